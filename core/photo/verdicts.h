#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/photo/import.h"

namespace bosk {

// What is known of a file that was looked through, once and for good: what import_photos says of it
// beside others, with these cameras or those, needs no second look.
struct PhotoFacts {
  std::filesystem::path file;
  std::optional<ContentHash> content;  // none: the file couldn't be read
  DecodedPhoto decoded;                // `pixels` are not needed here
  std::string trouble;                 // why there is nothing decoded; empty: there is
};

// Reads and decodes one file; a fault that the user can mend becomes `trouble`. Throws Cancelled,
// and Error where memory or processes ran out.
PhotoFacts look_through(const std::filesystem::path& file, PhotoDecoder& decoder,
                        const Progress& progress);

// The verdicts that import_photos gives on the files, in their order. Throws Error as it does when
// two cameras have one name.
std::vector<PhotoVerdict> photo_verdicts(std::span<const PhotoFacts> files,
                                         std::span<const Camera> cameras,
                                         const PhotoOptions& options);

// The steps of it, for import_photos.

using CamerasByName = std::map<std::string, const Camera*>;
CamerasByName cameras_by_name(std::span<const Camera> cameras);

ContentHash hash_of_photo(const std::filesystem::path& file);
void reject(PhotoVerdict& verdict, const std::string& reason);
// With the Error's sentence, but for the name of the file that it begins with.
void reject(PhotoVerdict& verdict, const Error& error);
// All accepted so far.
std::vector<PhotoVerdict> begun_verdicts(std::span<const std::filesystem::path> files);
// Of a pair the later one, so that the order of the files alone decides. No cameras: all may stay.
void reject_doubles(std::vector<PhotoVerdict>& verdicts);
void reject_without_camera(std::vector<PhotoVerdict>& verdicts, const CamerasByName& cameras);
// Completes the verdict on a decoded file and gives the photo but for its pixels. Throws Error
// where the file can't be used.
Photo judged_photo(PhotoVerdict& verdict, const DecodedPhoto& decoded, const CamerasByName& cameras,
                   const PhotoOptions& options);

}  // namespace bosk
