package org.dronewatch.placement.plan;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.Node;

/**
 * A sensor that may be bought, and where it may be installed.
 *
 * @param sensor settings of the sensor as in a scene file, without a position, such as
 *     {@code {use: blighter-a400-m10s}}
 * @param price price of one sensor, including its installation, 0 to 1e12, in the currency of the budget
 * @param places positions at which the sensor may be installed
 * @param line positions along a line
 * @param area positions within a polygon, such as a roof
 * @param aims number of directions, evenly spaced around the compass from the sensor's own azimuth, in which it may be
 *     aimed at each position, 1 to 72; 1 by default
 * @param positioners positioners on which the sensor may be mounted, instead of on a fixed mount, by name; in the
 *     layout, the name of a sensor on a positioner ends with the name of the positioner. At each position, there is one
 *     candidate on each positioner, in addition to one for each aim; none by default
 * @param exclusive whether such a sensor rules out other exclusive sensors, and sensors that are kept, at its position;
 *     {@code false} by default
 * @param atLeast minimum number of such sensors in the layout; 0 by default
 * @param atMost maximum number of such sensors in the layout; no limit by default
 */
public record OfferSettings(
        Node.Mapping sensor,
        @In(value = Quantity.NUMBER, from = 0, to = 1e12) double price,
        List<Position> places,
        Optional<LineOfPlaces> line,
        Optional<AreaOfPlaces> area,
        @In(value = Quantity.NUMBER, from = 1, to = 72) int aims,
        Map<String, MountOffer> positioners,
        boolean exclusive,
        @In(value = Quantity.NUMBER, from = 0, to = 1000) int atLeast,
        @In(value = Quantity.NUMBER, from = 0, to = 1000) Optional<Integer> atMost) {
    /** Checks the limits. */
    public OfferSettings {
        Limits.check(
                OfferSettings.class, sensor, price, places, line, area, aims, positioners, exclusive, atLeast, atMost);
        places = List.copyOf(places);
        positioners = Collections.unmodifiableMap(new LinkedHashMap<>(positioners));
        positioners.keySet().forEach(OfferSettings::checkName);
        int least = atLeast;
        if (atMost.filter(most -> most < least).isPresent()) {
            throw new IllegalArgumentException("atMost " + atMost.get() + ": must be at least atLeast, " + atLeast);
        }
    }

    private static void checkName(String name) {
        if (!name.matches("[A-Za-z][A-Za-z0-9_-]{0,15}")) {
            throw new IllegalArgumentException("positioners." + name
                    + ": a name must have 1 to 16 letters, digits, hyphens and underscores, and begin with a letter");
        }
    }

    /** A sensor for which no position is given yet. */
    @Defaults({"sensor", "price"})
    public static OfferSettings of(Node.Mapping sensor, double price) {
        return new OfferSettings(
                sensor, price, List.of(), Optional.empty(), Optional.empty(), 1, Map.of(), false, 0, Optional.empty());
    }
}
