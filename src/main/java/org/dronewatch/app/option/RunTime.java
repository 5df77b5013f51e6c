package org.dronewatch.app.option;

import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/** A time within a run, as a user writes it. */
public final class RunTime {
    private RunTime() {}

    /**
     * Reads a time.
     *
     * @param option name of the option in messages, such as {@code --time}
     * @param text a number of seconds, or a number with a unit of time
     * @param duration duration of the run, s
     * @throws InputException when the text is not a time within the run
     */
    public static double parse(String option, String text, double duration) {
        double seconds;
        try {
            seconds = Quantity.DURATION.parse(text);
        } catch (IllegalArgumentException e) {
            throw new InputException(GivenOption.words(option, text) + ": " + e.getMessage(), e);
        }
        if (!(seconds >= 0.0 && seconds <= duration)) {
            throw new InputException(
                    GivenOption.words(option, text) + ": must be 0 to " + duration + " s, the scene's duration");
        }
        return seconds;
    }
}
