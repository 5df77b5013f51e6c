package org.dronewatch.report.map;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.geo.GeoPoint;

/**
 * The properties of a feature, by name, in the order in which they were put: texts, numbers, truth values, and null for
 * missing values.
 */
final class Properties {
    private static final int DECIMALS = 6;

    private final Map<String, Object> values = new LinkedHashMap<>();

    Properties put(String name, String text) {
        values.put(name, text);
        return this;
    }

    /** A number; a non-finite one is null, as for a sound that did not arrive. */
    Properties put(String name, double number) {
        values.put(name, Double.isFinite(number) ? GeoPoint.rounded(number, DECIMALS) : null);
        return this;
    }

    Properties put(String name, boolean value) {
        values.put(name, value);
        return this;
    }

    /** A number if there is one. */
    Properties put(String name, OptionalDouble number) {
        return put(name, number.orElse(Double.NaN));
    }

    /** By name: text, BigDecimal, Boolean or null. */
    Map<String, Object> values() {
        return Collections.unmodifiableMap(values);
    }
}
