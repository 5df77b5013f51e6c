package org.dronewatch.app.option;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.InputException;

/** Settings as they are given on a command line. */
public final class SetOption {
    private SetOption() {}

    /**
     * The values, as text, by the paths of the settings.
     *
     * @param option name of the option in messages, such as {@code --set}
     * @param words the arguments, each of the form {@code PATH=VALUE}
     * @throws InputException with a one-line message when an argument is not of this form
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
