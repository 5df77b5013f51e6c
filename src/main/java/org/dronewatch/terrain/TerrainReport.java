package org.dronewatch.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.PlainText;
import org.dronewatch.terrain.io.ElevationFile;

/** Describes in lines what was read of a terrain, and warns of anything suspicious. */
record TerrainReport(TerrainSettings settings, Mosaic mosaic, List<ElevationFile> files) {
    private static final double KILOMETRE = 1000.0;

    /** Feet of all kinds are shorter than this, m, and metres longer. */
    private static final double LONGEST_FOOT = 0.31;

    List<String> lines(Posts posts, Heights heights, int all, PostTriangles kept, double level, Origin origin) {
        List<String> lines = new ArrayList<>();
        for (ElevationFile file : files) {
            lines.add(String.format(
                    Locale.ROOT,
                    "read %s: %,d x %,d posts, %s",
                    file.name(),
                    file.columns(),
                    file.rows(),
                    mosaic.crs()));
        }
        PostFrame.Row frame = posts.frame().newRow();
        int right = posts.columns() - 1;
        int low = posts.rows() - 1;
        frame.to(low / 2);
        frame.column(0);
        double west = frame.east(0.0);
        frame.column(right);
        double east = frame.east(0.0);
        frame.column(right / 2);
        frame.to(0);
        double north = frame.north(0.0);
        frame.to(low);
        double south = frame.north(0.0);
        lines.add(String.format(
                Locale.ROOT,
                "terrain: %s; %,d x %,d posts %.1f x %.1f m apart, %.1f to %.1f m high%s",
                extent(west / KILOMETRE, east / KILOMETRE, south / KILOMETRE, north / KILOMETRE),
                posts.columns(),
                posts.rows(),
                (east - west) / right,
                (north - south) / low,
                heights.lowest() + settings.verticalOffset(),
                heights.highest() + settings.verticalOffset(),
                atOrigin(level, origin)));
        lines.add(String.format(
                Locale.ROOT,
                "terrain: %,d of %,d triangles, maximum vertical error %.3f m (accuracy: %s m)%s",
                kept.count(),
                all,
                kept.error(),
                settings.accuracy(),
                heights.holes() == 0
                        ? ", no holes"
                        : String.format(
                                Locale.ROOT,
                                "; %,d %s",
                                heights.holes(),
                                heights.holes() == 1
                                        ? "post without a height (a hole)"
                                        : "posts without heights (holes)")));
        settings.credit().ifPresent(text -> lines.add("elevations: " + PlainText.line(text)));
        return lines;
    }

    /** Distances from the origin, km: how far it is to each side or, if it lies outside, between which limits. */
    private static String extent(double west, double east, double south, double north) {
        boolean isInside = west <= 0.0 && east >= 0.0 && south <= 0.0 && north >= 0.0;
        return isInside
                ? String.format(
                        Locale.ROOT,
                        "extends %.2f km west, %.2f km east, %.2f km north and %.2f km south of the origin",
                        -west,
                        east,
                        north,
                        -south)
                : String.format(
                        Locale.ROOT,
                        "extends from %s to %s and from %s to %s of the origin, which lies outside",
                        side(west, "west", "east"),
                        side(east, "west", "east"),
                        side(south, "south", "north"),
                        side(north, "south", "north"));
    }

    private static String side(double distance, String below, String above) {
        return String.format(Locale.ROOT, "%.2f km %s", Math.abs(distance), distance < 0.0 ? below : above);
    }

    private static String atOrigin(double level, Origin origin) {
        return Double.isNaN(level)
                ? ""
                : String.format(
                        Locale.ROOT,
                        ", %.1f m at the origin (z = %.1f m)",
                        level,
                        tenths(level - origin.height().orElse(0.0)));
    }

    /** Rounded as it is shown; never -0. */
    private static double tenths(double value) {
        return Math.rint(10.0 * value) / 10.0 + 0.0;
    }

    void warn(List<String> warnings, double level) {
        for (ElevationFile file : mosaic.unused()) {
            warnings.add(file.name() + ": no part of it lies within " + settings.radius() + " m of the origin");
        }
        settings.crs()
                .ifPresent(given -> files.forEach(file -> file.statedCrs()
                        .filter(own -> !own.equals(mosaic.crs().name()))
                        .ifPresent(own -> warnings.add(file.name() + ": states " + own + ", but is read as "
                                + mosaic.crs() + " (world.terrain.crs)"))));
        doubtUnit(warnings);
        for (ElevationFile file : files) {
            if (file.isSurfaceModel() && settings.surface() == ElevationSurface.DTM) {
                warnings.add(
                        file.name()
                                + ": its heights seem to be those of roofs and treetops, not of the ground; if so, set surface: dsm");
                break;
            }
        }
        if (Double.isNaN(level)) {
            warnings.add("terrain: there is no ground at the origin");
        }
    }

    /** Where maps are in feet, heights often are, too, and nothing else would show it. */
    private void doubtUnit(List<String> warnings) {
        CoordinateReferenceSystem crs = mosaic.crs();
        if (crs.isGeographic() || crs.unitLength() > LONGEST_FOOT) {
            return;
        }
        files.stream()
                .filter(file -> !file.statesUnit())
                .findFirst()
                .ifPresent(file -> warnings.add(String.format(
                        Locale.ROOT,
                        "%s: %s is a grid in feet, but the unit of the heights is not stated: they are taken to be in metres; if"
                                + " they are in US survey feet, state that, as in gdal_translate -a_srs %2$s+6360",
                        file.name(),
                        crs)));
    }
}
