package org.dronewatch.positioner;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A motorised mount with unlimited pan and limited tilt. It searches until a sensor that cues it reports the position
 * or direction of a drone; then it slews there as fast as it can, and follows the drone. It keeps following the first
 * drone until that drone has not been seen for the time {@code hold}.
 *
 * @param cues names of the sensors that cue it; they must measure directions, as radars, cameras and microphone arrays
 *     do
 * @param panSpeed pan rate, above 0 and at most 10 pi/3 rad/s
 * @param tiltSpeed tilt rate, above 0 and at most 10 pi/3 rad/s
 * @param minTilt lowest elevation of the axis, -pi/2 to pi/2, rad
 * @param maxTilt highest elevation of the axis, not below minTilt, -pi/2 to pi/2, rad
 * @param delay time from another sensor's detection until the positioner begins to slew, 0 to 60 s
 * @param hold time for which it keeps following a drone that neither its own camera nor a cueing sensor sees, 0 to
 *     3600 s
 * @param lockPixels minimum number of pixels on a drone, 1 or more, for the positioner's own camera to track it, even
 *     if the camera's detection function requires more; a camera that takes light and weather into account must at
 *     least detect it
 * @param search pattern of its search until it is cued
 * @param zoom how its lens zooms; omit it for a fixed lens
 * @param rangeSearch search along the direction measured by a cueing sensor that is at another position and measures no
 *     range
 */
public record PositionerSettings(
        List<String> cues,
        @In(value = Quantity.ANGULAR_SPEED, above = 0, to = 10 * Math.PI / 3) double panSpeed,
        @In(value = Quantity.ANGULAR_SPEED, above = 0, to = 10 * Math.PI / 3) double tiltSpeed,
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) @Formerly("lowest") double minTilt,
        @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) @Formerly("highest") double maxTilt,
        @In(value = Quantity.DURATION, from = 0, to = 60) double delay,
        @In(value = Quantity.DURATION, from = 0, to = 3600) double hold,
        @In(value = Quantity.PIXELS, from = 1, to = 1e6) @Formerly("lock") double lockPixels,
        SearchPattern search,
        Optional<ZoomSettings> zoom,
        @Minor RangeSearch rangeSearch) {
    /** The effects that the model of a positioner leaves out, for a report. */
    public static final String LEFT_OUT =
            "Positioners accelerate instantly and do not vibrate; their own cameras measure directions without errors.";

    /**
     * A positioner that turns at 60 degrees per second, from 50 degrees below the horizon to 60 above; half a second of
     * delay, 3 seconds of hold, 6 pixels to track; at rest until it is cued.
     */
    @Defaults
    public static final PositionerSettings DEFAULT = new PositionerSettings(
            List.of(),
            Math.toRadians(60.0),
            Math.toRadians(60.0),
            Math.toRadians(-50.0),
            Math.toRadians(60.0),
            0.5,
            3.0,
            6.0,
            new SearchPattern.Rest(),
            Optional.empty(),
            RangeSearch.DEFAULT);

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public PositionerSettings {
        Limits.check(
                PositionerSettings.class,
                cues,
                panSpeed,
                tiltSpeed,
                minTilt,
                maxTilt,
                delay,
                hold,
                lockPixels,
                search,
                zoom,
                rangeSearch);
        cues = List.copyOf(cues);
        if (new HashSet<>(cues).size() < cues.size()) {
            throw new IllegalArgumentException("cues " + cues + " must not name a sensor twice");
        }
        if (minTilt > maxTilt) {
            throw new IllegalArgumentException("minTilt " + Quantity.ANGLE.inWords(minTilt)
                    + " must be at most maxTilt " + Quantity.ANGLE.inWords(maxTilt));
        }
    }

    /**
     * The pointing of the positioner once it has turned to a position and zoomed in as far as possible.
     *
     * @param from position of the positioner, m
     * @param target the position to which it turns, m
     * @param widest its sensor's own field of view, rad
     * @return the pointing, with its elevation limited to the range of the tilt
     */
    public Pointing turnedTo(Position from, Position target, double widest) {
        Position offset = target.minus(from);
        Direction wanted = offset.length() > 0.0 ? Direction.of(offset) : new Direction(0.0, 0.0);
        return Pointing.still(tilted(wanted), zoom.map(ZoomSettings::tracked).orElse(widest), OptionalInt.empty());
    }

    /** A direction limited to the elevations that the positioner can reach. */
    Direction tilted(Direction wanted) {
        return new Direction(wanted.azimuth(), Math.max(minTilt, Math.min(maxTilt, wanted.elevation())));
    }

    /** These settings, cued by other sensors. */
    public PositionerSettings withCues(String... sensors) {
        return SettingsForm.with(this, "cues", List.of(sensors));
    }

    /** These settings with other pan and tilt rates, rad/s. */
    public PositionerSettings withSpeed(double pan, double tilt) {
        return SettingsForm.with(this, Map.of("panSpeed", pan, "tiltSpeed", tilt));
    }

    /** These settings with another time for which the positioner keeps following a drone that is no longer seen, s. */
    public PositionerSettings withHold(double seconds) {
        return SettingsForm.with(this, "hold", seconds);
    }

    /** These settings with another search pattern. */
    public PositionerSettings withSearch(SearchPattern pattern) {
        return SettingsForm.with(this, "search", pattern);
    }

    /** These settings with another search along the lines of cues without a range. */
    public PositionerSettings withRangeSearch(RangeSearch other) {
        return SettingsForm.with(this, "rangeSearch", other);
    }

    /** These settings with a lens that zooms. */
    public PositionerSettings withZoom(ZoomSettings lens) {
        return SettingsForm.with(this, "zoom", Optional.of(lens));
    }
}
