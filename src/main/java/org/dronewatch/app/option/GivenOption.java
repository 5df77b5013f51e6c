package org.dronewatch.app.option;

import org.dronewatch.setting.PlainText;

/** An option as messages quote it. */
public final class GivenOption {
    private GivenOption() {}

    /** The option with its value: {@code --cell 5m}; the option alone if the value is empty. */
    public static String words(String option, String value) {
        return (option + " " + PlainText.value(value)).strip();
    }
}
