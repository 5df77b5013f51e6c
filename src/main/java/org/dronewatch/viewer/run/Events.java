package org.dronewatch.viewer.run;

import java.util.Locale;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.sensor.Observation;
import org.dronewatch.viewer.part.Texts;

/** Detections in words. */
public final class Events {
    private Events() {}

    /** One line with the time, the sensor, what it detects or loses, the distance, and the measured value. */
    public static String text(DetectionEvent event) {
        Observation o = event.observation();
        return String.format(
                Locale.ROOT,
                "%s  %s %s %s at %.1f m (%s, needs %s)%s",
                Texts.time(o.arrival()),
                o.sensor(),
                event.gained() ? "detects" : "loses",
                o.drone(),
                o.range(),
                Texts.measured(o.value(), o.unit()),
                Texts.measured(o.threshold(), o.unit()),
                o.isUnknown() ? " over unknown ground" : "");
    }
}
