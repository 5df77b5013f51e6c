package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;

/** What a GeoTIFF file says about its map (OGC GeoTIFF standard 1.1, OGC 19-008r4), and where its posts are on it. */
final class GeoKeys {
    private static final int DIRECTORY = 34735;
    private static final int PIXEL_SCALE = 33550;
    private static final int TIE_POINTS = 33922;
    private static final int MATRIX = 34264;

    private static final int RASTER_TYPE = 1025;
    private static final int PIXEL_IS_POINT = 2;
    private static final int GEOGRAPHIC = 2048;
    private static final int PROJECTED = 3072;
    private static final int VERTICAL = 4096;
    private static final int VERTICAL_UNITS = 4099;
    private static final int USER_DEFINED = 32767;
    private static final int METRE = 9001;
    private static final int FOOT = 9002;
    private static final int US_SURVEY_FOOT = 9003;
    private static final Map<Integer, Double> UNITS = Map.of(METRE, 1.0, FOOT, 0.3048, US_SURVEY_FOOT, 1200.0 / 3937.0);

    /** The units of vertical systems whose heights are in feet (EPSG register); those of others are metres. */
    private static final Map<Integer, Integer> SYSTEMS_IN_FEET =
            Map.of(5702, US_SURVEY_FOOT, 6360, US_SURVEY_FOOT, 8052, US_SURVEY_FOOT, 8050, FOOT, 8228, FOOT);

    private final String name;
    private final TiffDirectory tags;
    private final Map<Integer, Integer> keys = new HashMap<>();

    GeoKeys(String name, TiffDirectory tags) throws IOException {
        this.name = name;
        this.tags = tags;
        long[] directory = tags.longs(DIRECTORY);
        for (int i = 4; i + 3 < directory.length; i += 4) {
            if (directory[i + 1] == 0) {
                keys.put((int) directory[i], (int) directory[i + 3]);
            }
        }
    }

    /** The system of the map, if it has a code. */
    Optional<CoordinateReferenceSystem> crs() {
        try {
            return statedCrs().map(CoordinateReferenceSystem::of);
        } catch (InputException e) {
            throw new InputException(name + ": " + e.getMessage() + "; world.terrain.crs can name another", e);
        }
    }

    /** The code of that system, whether it is known or not. */
    Optional<String> statedCrs() {
        int code = keys.getOrDefault(PROJECTED, keys.getOrDefault(GEOGRAPHIC, 0));
        return code == 0 || code == USER_DEFINED ? Optional.empty() : Optional.of("EPSG:" + code);
    }

    /** Whether the unit of heights is stated, by itself or by the vertical system. */
    boolean statesUnit() {
        int system = keys.getOrDefault(VERTICAL, 0);
        return keys.containsKey(VERTICAL_UNITS) || system != 0 && system != USER_DEFINED;
    }

    /** Metres of a unit of height, which takes precedence over that of the vertical system. */
    double unit() {
        int ofSystem = SYSTEMS_IN_FEET.getOrDefault(keys.getOrDefault(VERTICAL, 0), METRE);
        int code = keys.getOrDefault(VERTICAL_UNITS, ofSystem);
        Double metres = UNITS.get(code);
        if (metres == null) {
            throw new InputException(
                    name + ": heights in unit " + code + " must be in metres (9001) or feet (9002, 9003)");
        }
        return metres;
    }

    /** Where the posts are: at the centres of pixels that are areas, or at pixels that are points. */
    Lattice lattice() throws IOException {
        double[] m = tags.doubles(MATRIX);
        double[] scale = tags.doubles(PIXEL_SCALE);
        double[] tie = tags.doubles(TIE_POINTS);
        Lattice corner;
        if (m.length >= 8 && scale.length == 0) {
            corner = new Lattice(m[3], m[7], m[0], m[4], m[1], m[5]);
        } else if (scale.length >= 2 && tie.length >= 6) {
            corner = new Lattice(tie[3] - tie[0] * scale[0], tie[4] + tie[1] * scale[1], scale[0], 0.0, 0.0, -scale[1]);
        } else {
            throw new InputException(name
                    + ": has no georeferencing (tags 33550 and 33922, or 34264): add it with gdal_translate"
                    + " -a_ullr W N E S -a_srs EPSG:CODE");
        }
        if (!corner.isUsable()) {
            throw new InputException(
                    name + ": its georeferencing (tags 33550 and 33922, or 34264) spans no area: " + corner);
        }
        if (keys.getOrDefault(RASTER_TYPE, 1) == PIXEL_IS_POINT) {
            return corner;
        }
        return new Lattice(
                corner.xAt(0.5, 0.5),
                corner.yAt(0.5, 0.5),
                corner.columnX(),
                corner.columnY(),
                corner.rowX(),
                corner.rowY());
    }
}
