package org.dronewatch.viewer.beside;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.sensor.Observation;
import org.dronewatch.viewer.part.Texts;

/**
 * When a drone is first detected in two runs, by one sensor or by any.
 *
 * @param drone its name
 * @param sensor the sensor; empty for any
 * @param here in the run that is shown
 * @param there in the other run
 */
record DetectionComparison(String drone, Optional<String> sensor, Side here, Side there) {
    /** Times that are written in the same way are the same, s. */
    private static final double SAME = 0.005;

    /**
     * The part of one run in the comparison.
     *
     * @param exists whether the run has the sensor, switched on, and the drone
     * @param first the first detection, if there is one
     * @param finished whether all of the run has been simulated
     * @param detects whether the drone is detected at the time shown
     */
    record Side(boolean exists, Optional<Observation> first, boolean finished, boolean detects) {
        /** The time of the first detection, and the sensor that made it if none is given. */
        private String text(boolean isOfAny) {
            if (!exists) {
                return "absent";
            }
            return first.map(o -> Texts.time(o.arrival()) + (isOfAny ? " by " + o.sensor() : ""))
                    .orElse(finished ? "never" : "not yet");
        }

        private boolean isKnown() {
            return first.isPresent() || finished;
        }
    }

    /** The first detection in the run that is shown, in words. */
    String hereText() {
        return here.text(sensor.isEmpty());
    }

    /** The first detection in the other run, in words. */
    String thereText() {
        return there.text(sensor.isEmpty());
    }

    /** Whether the first detections of both runs are known to differ. */
    boolean isDifferent() {
        return !difference().isEmpty() && !difference().equals("same");
    }

    /** How the run that is shown differs from the other; empty as long as it is not known. */
    String difference() {
        if (!here.exists() || !there.exists()) {
            return here.exists() ? "this run only" : "other run only";
        }
        if (here.first().isPresent() && there.first().isPresent()) {
            double later = here.first().get().arrival() - there.first().get().arrival();
            if (Math.abs(later) < SAME) {
                return isBySameSensor() ? "same" : "same time";
            }
            return String.format(Locale.ROOT, "%.2f s %s", Math.abs(later), later < 0.0 ? "earlier" : "later");
        }
        if (!here.isKnown() || !there.isKnown()) {
            return "";
        }
        if (here.first().isEmpty() && there.first().isEmpty()) {
            return "same";
        }
        return here.first().isPresent() ? "gained" : "lost";
    }

    private boolean isBySameSensor() {
        return here.first().map(Observation::sensor).equals(there.first().map(Observation::sensor));
    }

    /** In which of the runs the drone is detected at the time shown. */
    String now() {
        if (here.detects() && there.detects()) {
            return "both";
        }
        return here.detects() ? "this" : there.detects() ? "other" : "-";
    }
}
