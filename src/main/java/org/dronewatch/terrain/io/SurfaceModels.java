package org.dronewatch.terrain.io;

import java.util.List;

/**
 * Elevation models of the whole earth, all of which were measured from above, so that their heights include roofs and
 * trees.
 */
final class SurfaceModels {
    private static final List<String> NAMES = List.of(
            "copernicus",
            "glo_30",
            "glo30",
            "glo-30",
            "glo_90",
            "glo90",
            "cop30",
            "cop90",
            "srtm",
            "aster",
            "alos",
            "aw3d",
            "nasadem",
            "tandem");

    private SurfaceModels() {}

    /** Whether a file seems to be from one of them by its name, in lower case. */
    static boolean isOne(String name) {
        return NAMES.stream().anyMatch(name::contains);
    }
}
