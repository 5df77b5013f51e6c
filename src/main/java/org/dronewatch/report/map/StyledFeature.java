package org.dronewatch.report.map;

import java.awt.Color;
import java.util.Map;

/**
 * A feature on a map.
 *
 * @param role its role
 * @param folder title of its folder
 * @param name displayed name
 * @param shape where it is
 * @param colour its colour
 * @param properties its properties, by name: text, BigDecimal, Boolean or null, as {@link Properties} gives them
 */
record StyledFeature(Role role, String folder, String name, Shape shape, Color colour, Map<String, Object> properties) {
    /** A feature in the folder of its role. */
    StyledFeature(Role role, String name, Shape shape, Color colour, Properties properties) {
        this(role, role.folder(), name, shape, colour, properties.values());
    }
}
