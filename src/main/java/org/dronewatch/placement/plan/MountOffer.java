package org.dronewatch.placement.plan;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.Node;

/**
 * A positioner on which a sensor may be mounted, instead of on a fixed mount.
 *
 * @param positioner settings of the positioner as in a scene file, such as {@code {use: viper}}; in the layout, it is
 *     cued by all sensors that measure directions unless its settings name the sensors that cue it
 * @param price price of one positioner, in addition to that of the sensor, 0 to 1e12, in the currency of the budget
 */
public record MountOffer(Node.Mapping positioner, @In(value = Quantity.NUMBER, from = 0, to = 1e12) double price) {
    /** Checks the limits. */
    public MountOffer {
        Limits.check(MountOffer.class, positioner, price);
    }

    /** A positioner with its price. */
    @Defaults({"positioner", "price"})
    public static MountOffer of(Node.Mapping positioner, double price) {
        return new MountOffer(positioner, price);
    }
}
