#pragma once

#include "core/base/binary.h"
#include "core/matte/matte.h"
#include "core/photo/import.h"

namespace bosk {

// What the import stage leaves: the accepted photos, and why the others are not among them.
struct ImportedPhotos {
  Photos photos;
  std::vector<PhotoVerdict> verdicts;  // stored without the files' paths and metadata
};

// Photos and mattes as the cache holds them: 16 bits a channel, values clamped to 0 to 1, so that a
// capture of 24 photos takes some 100 MB instead of 500. Colour where alpha is 0 becomes 0. Reading
// back and storing again changes nothing any more.
void write_stored(BinaryWriter& writer, const ImportedPhotos& imported);
ImportedPhotos read_stored_import(BinaryReader& reader);
void write_stored(BinaryWriter& writer, const Photos& photos);
Photos read_stored_photos(BinaryReader& reader);
void write_stored(BinaryWriter& writer, const Mattes& mattes);
Mattes read_stored_mattes(BinaryReader& reader);

}  // namespace bosk
