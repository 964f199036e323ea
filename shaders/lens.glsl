// core/photo/camera.cpp in single precision, with derivatives. Needs frame.glsl.

// A point on the screen and how it moves as the point in the camera's frame moves.
struct Seen {
  bool inside;
  vec2 pixel;
  mat3x2 derivative;
};

mat3x2 straight_derivative(vec3 p) {
  vec2 straight = p.xy / p.z;
  return mat3x2(1.0 / p.z, 0.0, 0.0, 1.0 / p.z, -straight.x / p.z, -straight.y / p.z);
}

Seen seen_straight(vec3 p) { return Seen(true, p.xy / p.z, straight_derivative(p)); }

Seen seen_opencv(vec3 point) {
  vec2 p = point.xy / point.z;
  float r2 = dot(p, p);
  if (!(r2 < fold)) return Seen(false, vec2(0.0), mat3x2(0.0));
  vec3 k = vec3(distortion_low.xy, distortion_high.x), under_k = distortion_high.yzw;
  float p1 = distortion_low.z, p2 = distortion_low.w;
  float over = 1.0 + r2 * (k.x + r2 * (k.y + r2 * k.z));
  float under = 1.0 + r2 * (under_k.x + r2 * (under_k.y + r2 * under_k.z));
  float over_slope = k.x + r2 * (2.0 * k.y + r2 * 3.0 * k.z);
  float under_slope = under_k.x + r2 * (2.0 * under_k.y + r2 * 3.0 * under_k.z);
  float factor = over / under;
  float slope = (over_slope - factor * under_slope) / under;
  vec2 shift = vec2(2.0 * p1 * p.x * p.y + p2 * (r2 + 2.0 * p.x * p.x),
                    p1 * (r2 + 2.0 * p.y * p.y) + 2.0 * p2 * p.x * p.y);
  float across = 2.0 * slope * p.x * p.y + 2.0 * p1 * p.x + 2.0 * p2 * p.y;
  mat2 bend = mat2(factor + 2.0 * slope * p.x * p.x + 2.0 * p1 * p.y + 6.0 * p2 * p.x, across,
                   across, factor + 2.0 * slope * p.y * p.y + 6.0 * p1 * p.y + 2.0 * p2 * p.x);
  return Seen(determinant(bend) > 0.0, factor * p + shift, bend * straight_derivative(point));
}

Seen seen_fisheye(vec3 p) {
  float radius = length(p.xy);
  if (radius < 1e-3 * p.z) return seen_straight(p);  // equal there to a millionth
  vec4 k = distortion_low;
  float angle = atan(radius, p.z);
  if (!(angle < fold)) return Seen(false, vec2(0.0), mat3x2(0.0));
  float a2 = angle * angle;
  float bent = angle * (1.0 + a2 * (k.x + a2 * (k.y + a2 * (k.z + a2 * k.w))));
  float slope = 1.0 + a2 * (3.0 * k.x + a2 * (5.0 * k.y + a2 * (7.0 * k.z + a2 * 9.0 * k.w)));
  vec2 outwards = p.xy / radius;
  float squared = radius * radius + p.z * p.z;
  // The picture's radius grows with the angle; across it, all turns rigidly
  vec3 by_angle = slope * vec3(outwards * p.z, -radius) / squared;
  float turn = bent / radius;
  vec2 aside = vec2(-outwards.y, outwards.x);
  mat3x2 derivative = mat3x2(outwards * by_angle.x + aside * (aside.x * turn),
                             outwards * by_angle.y + aside * (aside.y * turn),
                             outwards * by_angle.z);
  return Seen(true, bent * outwards, derivative);
}

// Not inside: behind the camera or where the lens model folds over.
Seen seen_through_lens(vec3 point_in_camera) {
  if (!(point_in_camera.z > 0.0)) return Seen(false, vec2(0.0), mat3x2(0.0));
  Seen seen = lens_model == kStraight ? seen_straight(point_in_camera)
              : lens_model == kOpencv ? seen_opencv(point_in_camera)
                                      : seen_fisheye(point_in_camera);
  seen.pixel = focal_px * seen.pixel + principal_px;
  for (int axis = 0; axis < 3; ++axis) seen.derivative[axis] *= focal_px;
  return seen;
}
