#pragma once

#include <floe/analysis.hpp>
#include <floe/plate/mindlin.hpp>

namespace floe {

/// Frequencies over which the seas are integrated [rad/s]; empty where none are asked for.
struct SeaBand {
  double from = 0.0;
  double to = 0.0;
  bool asked() const { return to > from; }
};

/// Chooses the band and holds it against every sea: warns where more than 1 % of m0 lie outside,
/// throws DataError for more than 5 % unless the sea allows it. Zones are held against the plate:
/// a warning where they change within a wavelength, DataError where they leave a part of it out.
///
/// A band of the case's own is held against the mesh as the regular waves are: InputError for fewer
/// than 2 nodes a wavelength unless the case allows it, a warning for fewer than 4. Warns too where
/// the modes are few for the frequencies below which nine tenths of a sea's m0 lie. `plate_mesh` is
/// the plate's own mesh, if it has one.
SeaBand prepare_seas(const Case& data, const mesh::Q8Mesh& fluid, const mesh::Q8Mesh* plate_mesh,
                     const plate::PlateRegions& regions, Log& log);

}  // namespace floe
