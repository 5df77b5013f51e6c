package org.dronewatch.buildings.io;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The coordinate system of a map, as determined by its format, by a statement in the file, or by one in the scene,
 * which takes precedence over the file.
 *
 * @param rule what the format requires
 * @param stated what the file states about its coordinates: a code, a URN or a URL, not checked yet; empty if it states
 *     nothing
 * @param member name of the member of the file that states its system, for messages
 * @param extent extent of the coordinates in the file
 * @param foreign description of the first point that cannot be a longitude and latitude, with its location in the file;
 *     empty if there is none
 */
public record MapSystem(Rule rule, Optional<String> stated, String member, MapExtent extent, Optional<String> foreign) {
    private static final Pattern CODE = Pattern.compile(".*EPSG(?:/[^/]*/|:[^:]*:|:)(\\d{4,6})");

    /** Longitude and latitude in degrees by OGC's own name, as GeoJSON of ogr2ogr and QGIS states them. */
    private static final Pattern CRS84 = Pattern.compile(".*CRS84");

    /** What formats specify about coordinates. */
    public enum Rule {
        /** Always longitude and latitude (WGS 84). */
        ALWAYS_DEGREES,
        /** Longitude and latitude unless the file states something else. */
        DEGREES,
        /** Stated in each file. */
        STATED
    }

    /** Whether the scene has to state the system of the coordinates: the file states none, or one that is not known. */
    public boolean isUnknown() {
        if (stated.isEmpty()) {
            return rule == Rule.STATED || foreign.isPresent();
        }
        try {
            parsed("", stated.get());
            return false;
        } catch (InputException e) {
            return true;
        }
    }

    /**
     * The system of the coordinates.
     *
     * @param file name of the map, for messages
     * @param given the system that the scene states, if any
     * @throws InputException with a one-line message when the system is neither given nor stated, is not known, or does
     *     not fit the coordinates
     */
    public CoordinateReferenceSystem crs(String file, Optional<CoordinateReferenceSystem> given) {
        if (rule == Rule.ALWAYS_DEGREES) {
            given.filter(grid -> !grid.isGeographic()).ifPresent(grid -> {
                throw new InputException(file + ": has longitude and latitude, like all OpenStreetMap data, but crs is "
                        + grid + ": leave out crs");
            });
            return CoordinateReferenceSystem.wgs84();
        }
        if (given.isEmpty() && stated.isEmpty() && rule == Rule.STATED) {
            throw new InputException(
                    file + ": does not state its coordinate reference system: set crs, as in crs: EPSG:25832");
        }
        CoordinateReferenceSystem crs = given.orElseGet(
                () -> stated.map(text -> parsed(file, text)).orElseGet(CoordinateReferenceSystem::wgs84));
        if (crs.isGeographic() && foreign.isPresent()) {
            throw new InputException(file + ": " + foreign.get()
                    + " but must be longitude and latitude, -180 to 180 and -90 to 90 degrees: for coordinates of a grid, set"
                    + " crs, as in crs: EPSG:25832");
        }
        return crs;
    }

    /** The system that the file states, if the scene states another one, which is used instead. */
    public Optional<String> overruled(CoordinateReferenceSystem used) {
        return stated.filter(text -> !isSame(text, used)).map(PlainText::value);
    }

    private static boolean isSame(String text, CoordinateReferenceSystem used) {
        return used.name()
                .equals(
                        CRS84.matcher(text).matches()
                                ? CoordinateReferenceSystem.wgs84().name()
                                : code(text));
    }

    private static String code(String text) {
        Matcher code = CODE.matcher(text);
        return code.matches() ? "EPSG:" + code.group(1) : "";
    }

    private CoordinateReferenceSystem parsed(String file, String text) {
        if (CRS84.matcher(text).matches()) {
            return CoordinateReferenceSystem.wgs84();
        }
        String code = code(text);
        if (code.isEmpty()) {
            throw new InputException(file + ": " + member + " is '" + PlainText.value(text)
                    + "' but must end in an EPSG code; set world.buildings.crs instead");
        }
        try {
            return CoordinateReferenceSystem.of(code);
        } catch (InputException e) {
            throw new InputException(file + ": " + member + ": " + e.getMessage(), e);
        }
    }
}
