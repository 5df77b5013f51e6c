package org.dronewatch.report.map;

import java.awt.Color;
import java.util.Map;

/**
 * One thing on a map.
 *
 * @param role what it stands for
 * @param name what people call it
 * @param shape where it is
 * @param colour what it is drawn in
 * @param properties its properties, by name: text, BigDecimal or null, as {@link Properties} gives them
 */
record MapFeature(Role role, String name, Shape shape, Color colour, Map<String, Object> properties) {
    MapFeature(Role role, String name, Shape shape, Color colour, Properties properties) {
        this(role, name, shape, colour, properties.values());
    }
}
