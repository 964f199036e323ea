#include "core/phantom/ray_scene.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <cstring>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr float kNear = 1e-4f;  // a ray doesn't meet the surface that it leaves

RTCDevice new_device() {
  RTCDevice device = rtcNewDevice(nullptr);
  if (device == nullptr) throw Error("Embree could not start its ray caster", ErrorKind::resource);
  return device;
}

// Embree builds its tree with the threads of the arena it is called in.
void commit_alone(RTCDevice device, RTCScene scene) {
  tbb::task_arena alone(1, 1);
  alone.execute([&] { rtcCommitScene(scene); });
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
    throw Error("Embree could not build the tree's ray structure, most likely for want of memory",
                ErrorKind::resource);
  }
}

template <class T>
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<T>& items) {
  void* target = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
  if (target == nullptr) throw Error("out of memory for the tree's triangles", ErrorKind::resource);
  std::memcpy(target, items.data(), items.size() * sizeof(T));
}

RTCRay ray_from(const glm::vec3& origin, const glm::vec3& direction, float far) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = kNear, ray.tfar = far;
  ray.mask = 0xffffffff;
  return ray;
}

}  // namespace

struct RayScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::shared_ptr<const Handles> mesh;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const std::vector<glm::vec3>& vertices,
                   const std::vector<glm::uvec3>& triangles) {
  const auto made = std::make_shared<Handles>();
  made->device = new_device();
  made->scene = rtcNewScene(made->device);
  RTCGeometry geometry = rtcNewGeometry(made->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices);
  copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(made->scene, geometry);
  rtcReleaseGeometry(geometry);
  commit_alone(made->device, made->scene);
  handles_ = made;
}

RayScene::RayScene(const RayScene& mesh, const std::vector<MeshCopy>& copies) {
  const auto made = std::make_shared<Handles>();
  made->mesh = mesh.handles_;
  made->device = mesh.handles_->device;
  rtcRetainDevice(made->device);
  made->scene = rtcNewScene(made->device);
  for (const MeshCopy& copy : copies) {
    RTCGeometry geometry = rtcNewGeometry(made->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, mesh.handles_->scene);
    const float s = copy.scale;
    const std::array<float, 12> columns{
        s, 0, 0, 0, s, 0, 0, 0, s, copy.shift.x, copy.shift.y, copy.shift.z};
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(made->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  commit_alone(made->device, made->scene);
  handles_ = made;
}

RayHit RayScene::first_hit(const glm::vec3& origin, const glm::vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit found{};
  found.ray = ray_from(origin, direction, 1e30f);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(handles_->scene, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {found.hit.primID, found.hit.instID[0], found.ray.tfar,
          found.hit.u,      found.hit.v,         {found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z}};
}

PacketHits RayScene::first_hits(const glm::vec3& origin, const PacketDirections& directions) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit8 packet;
  std::memset(&packet, 0, sizeof packet);
  alignas(32) std::array<int, kPacketRays> valid;
  for (int k = 0; k < kPacketRays; ++k) {
    const auto i = std::size_t(k);
    packet.ray.org_x[k] = origin.x, packet.ray.org_y[k] = origin.y, packet.ray.org_z[k] = origin.z;
    packet.ray.dir_x[k] = directions[i].x, packet.ray.dir_y[k] = directions[i].y;
    packet.ray.dir_z[k] = directions[i].z;
    packet.ray.tnear[k] = kNear, packet.ray.tfar[k] = 1e30f, packet.ray.mask[k] = 0xffffffff;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    valid[i] = -1;
  }
  rtcIntersect8(valid.data(), handles_->scene, &context, &packet);
  PacketHits hits;
  for (int k = 0; k < kPacketRays; ++k) {
    if (packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[std::size_t(k)] = {
        packet.hit.primID[k], 0,
        packet.ray.tfar[k],   packet.hit.u[k],
        packet.hit.v[k],      {packet.hit.Ng_x[k], packet.hit.Ng_y[k], packet.hit.Ng_z[k]}};
  }
  return hits;
}

bool RayScene::blocked(const glm::vec3& origin, const glm::vec3& direction, float far) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = ray_from(origin, direction, far);
  rtcOccluded1(handles_->scene, &context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace bosk
