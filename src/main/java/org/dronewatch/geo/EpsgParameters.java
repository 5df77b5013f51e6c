package org.dronewatch.geo;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.locationtech.proj4j.io.Proj4FileReader;

/**
 * What PROJ4J must know about a system of the EPSG register: the lines of the register that comes with PROJ4J, without
 * the parameters that it does not understand, and with those that some lines lack.
 */
final class EpsgParameters {
    /** The horizontal parts of systems with a height that PROJ4J's register does not have, by EPSG code. */
    private static final Map<Integer, Integer> HORIZONTAL = Map.of(4937, 4258, 4979, 4326, 9518, 4326, 9707, 4326);

    private static final Set<Integer> KROVAK = Set.of(2065, 5513, 5514);

    private static final String SHIFT = "+towgs84=";

    /**
     * The shift from S-JTSK to WGS 84 in the Czech Republic, accurate to a metre (EPSG 5239, here as a position
     * vector). The register of PROJ4J has a shift along the axes alone, which is 10 m off.
     */
    private static final String CZECH_SHIFT = SHIFT + "572.213,85.334,461.94,4.9732,1.529,5.2484,3.5378";

    private EpsgParameters() {}

    /** The parameters of a system; none if the register does not have it. */
    static String[] of(int code) {
        String[] stated = stated(HORIZONTAL.getOrDefault(code, code));
        Stream<String> horizontal = Arrays.stream(stated).filter(EpsgParameters::isHorizontal);
        if (KROVAK.contains(code)) {
            horizontal = horizontal.map(one -> one.startsWith(SHIFT) ? CZECH_SHIFT : one);
        }
        return horizontal.toArray(String[]::new);
    }

    private static boolean isHorizontal(String parameter) {
        return !parameter.startsWith("+vunits=")
                && !parameter.startsWith("+vto_meter=")
                && !parameter.startsWith("+geoidgrids=");
    }

    private static String[] stated(int code) {
        try {
            String[] found = new Proj4FileReader().readParametersFromFile("epsg", Integer.toString(code));
            return found == null ? new String[0] : found;
        } catch (IOException e) {
            throw new UncheckedIOException("the register of coordinate reference systems cannot be read", e);
        }
    }
}
