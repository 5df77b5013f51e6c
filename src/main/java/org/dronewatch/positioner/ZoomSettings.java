package org.dronewatch.positioner;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A lens that zooms in on the drone that the camera tracks. While the positioner searches, the lens has the sensor's
 * own field of view.
 *
 * @param cued field of view while another sensor cues it: wide enough for that sensor's errors, pi/18000 to 3.124 rad
 *     (0.01 to 179 degrees)
 * @param tracked field of view while the positioner's own camera tracks the drone, pi/18000 to 3.124 rad (0.01 to 179
 *     degrees)
 * @param time time to zoom from the sensor's own field of view to the narrowest, 0 to 60 s
 */
public record ZoomSettings(
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = In.WIDEST_PICTURE) double cued,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = In.WIDEST_PICTURE) double tracked,
        @In(value = Quantity.DURATION, from = 0, to = 60) double time) {
    /** Checks the limits. */
    public ZoomSettings {
        Limits.check(ZoomSettings.class, cued, tracked, time);
        if (tracked > cued) {
            throw new IllegalArgumentException("tracked " + Quantity.ANGLE.inWords(tracked) + " must be at most cued "
                    + Quantity.ANGLE.inWords(cued) + ": the camera zooms in on the drone that it tracks");
        }
    }

    /** A lens with the given fields of view, rad, that takes two seconds for the full zoom. */
    @Defaults({"cued", "tracked"})
    public static ZoomSettings of(double cued, double tracked) {
        return new ZoomSettings(cued, tracked, 2.0);
    }
}
