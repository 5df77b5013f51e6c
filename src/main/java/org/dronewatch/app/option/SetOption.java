package org.dronewatch.app.option;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.InputException;

/** Settings as they are given on a command line. */
public final class SetOption {
    private SetOption() {}

    /**
     * Values by their paths.
     *
     * @param option for messages
     * @param words each {@code PATH=VALUE}
     * @throws InputException with a one-line message when a word is not of this form
     */
    public static Map<String, String> parsed(String option, List<String> words) {
        Map<String, String> values = new LinkedHashMap<>();
        for (String word : words) {
            int equals = word.indexOf('=');
            if (equals < 1) {
                throw new InputException(GivenOption.words(option, word) + ": must be PATH=VALUE");
            }
            values.put(
                    word.substring(0, equals).strip(),
                    word.substring(equals + 1).strip());
        }
        return values;
    }
}
