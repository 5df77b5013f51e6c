package org.dronewatch.report.coverage;

import java.util.Locale;
import org.dronewatch.sensor.Cause;

/** The keys of causes in JSON files. */
public final class CauseKey {
    private CauseKey() {}

    /** The key of a cause, such as {@code hidden-by-terrain}. */
    public static String of(Cause cause) {
        return cause.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
