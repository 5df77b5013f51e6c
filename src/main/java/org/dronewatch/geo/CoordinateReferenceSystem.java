package org.dronewatch.geo;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.locationtech.proj4j.CRSFactory;
import org.locationtech.proj4j.Proj4jException;

/**
 * The coordinate reference system of a map: a national grid, a UTM zone, or longitude and latitude on some datum, by
 * its code in the EPSG register. Only the horizontal part of a compound system, which adds a height, is used: heights
 * are not converted. Coordinates are always x to the east, y to the north, in the units of the system (degrees for
 * longitude and latitude), whatever their order in the register. Immutable; PROJ4J transforms the coordinates.
 */
public final class CoordinateReferenceSystem {
    private static final Pattern CODE = Pattern.compile(
            "(?:EPSG:|URN:OGC:DEF:CRS:EPSG:[^:]*:|HTTPS?://WWW\\.OPENGIS\\.NET/DEF/CRS/EPSG/[^/]*/)" + "(\\d{4,6})");

    /** Longitude and latitude by the name that OGC gives them. */
    private static final Pattern CRS84 =
            Pattern.compile("(?:OGC:|URN:OGC:DEF:CRS:OGC:[^:]*:|HTTPS?://WWW\\.OPENGIS\\.NET/DEF/CRS/OGC/[^/]*/)CRS84");

    private static final String EXAMPLE = "must be an EPSG code, as in EPSG:25832";

    /** Looking one up takes milliseconds. */
    private static final Map<Integer, CoordinateReferenceSystem> KNOWN = new ConcurrentHashMap<>();

    private final String name;
    private final org.locationtech.proj4j.CoordinateReferenceSystem system;

    private CoordinateReferenceSystem(String name, org.locationtech.proj4j.CoordinateReferenceSystem system) {
        this.name = name;
        this.system = system;
    }

    /**
     * A system by its code.
     *
     * @param code such as {@code EPSG:25832}, in upper or lower case, or the URN or URL by which a file states it;
     *     longitude and latitude may also be named {@code OGC:CRS84}
     * @throws InputException when this is not a code, or the system is not in PROJ4J's register, or is neither a grid
     *     nor longitude and latitude
     */
    public static CoordinateReferenceSystem of(String code) {
        String shown = PlainText.value(code);
        String upper = code.strip().toUpperCase(Locale.ROOT);
        Matcher matcher = CODE.matcher(CRS84.matcher(upper).matches() ? "EPSG:4326" : upper);
        if (!matcher.matches()) {
            throw new InputException("coordinate reference system '" + shown + "' " + EXAMPLE);
        }
        return KNOWN.computeIfAbsent(Integer.parseInt(matcher.group(1)), CoordinateReferenceSystem::find);
    }

    /**
     * Longitude and latitude in degrees on the ellipsoid of GPS. Looked up on first use: most scenes have no map and
     * should not load PROJ4J's classes.
     */
    public static CoordinateReferenceSystem wgs84() {
        return of("EPSG:4326");
    }

    private static CoordinateReferenceSystem find(int number) {
        String name = "EPSG:" + number;
        String[] parameters = EpsgParameters.of(number);
        if (parameters.length == 0) {
            throw new InputException("coordinate reference system '" + name
                    + "' is not known: give the EPSG code of the system that the file uses");
        }
        if (Arrays.asList(parameters).contains("+proj=geocent")) {
            throw new InputException("coordinate reference system '" + name
                    + "' has earth-centred coordinates, but must have those of a map, as in EPSG:25832");
        }
        try {
            return new CoordinateReferenceSystem(name, new CRSFactory().createFromParameters(name, parameters));
        } catch (Proj4jException e) {
            throw new InputException("coordinate reference system '" + name + "' cannot be used: " + e.getMessage(), e);
        }
    }

    /**
     * Checks a code in a setting.
     *
     * @throws IllegalArgumentException when a code is given but {@link #of} refuses it
     */
    public static void checkSetting(Optional<String> code) {
        try {
            code.ifPresent(CoordinateReferenceSystem::of);
        } catch (InputException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** The code of the system, such as {@code EPSG:25832}. */
    public String name() {
        return name;
    }

    /** Whether the coordinates are longitude and latitude in degrees. */
    public boolean isGeographic() {
        return system.getProjection().isGeographic();
    }

    /**
     * The length of the unit of the coordinates, m: 1 for most grids, 0.3048 for those in feet.
     *
     * @throws IllegalStateException if the coordinates are {@linkplain #isGeographic() degrees}
     */
    public double unitLength() {
        if (isGeographic()) {
            throw new IllegalStateException(name + " has coordinates in degrees, not in a unit of length");
        }
        return 1.0 / system.getProjection().getFromMetres();
    }

    /** The system as PROJ4J represents it. */
    org.locationtech.proj4j.CoordinateReferenceSystem system() {
        return system;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CoordinateReferenceSystem that && name.equals(that.name);
    }

    @Override
    public int hashCode() {
        return name.hashCode();
    }

    @Override
    public String toString() {
        return name;
    }
}
