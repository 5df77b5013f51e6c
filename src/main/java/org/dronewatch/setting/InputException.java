package org.dronewatch.setting;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Reports wrong input by the user: a file, a field, an option. The message, which is shown unchanged, has one line for
 * each mistake, with its location, the value and the limit.
 */
public class InputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** A problem described in one line. */
    public InputException(String message) {
        super(PlainText.line(message));
    }

    /** A problem described in one line, with its cause. */
    public InputException(String message, Throwable cause) {
        super(PlainText.line(message), cause);
    }

    /** Several problems, each described in one line. */
    public InputException(List<String> problems) {
        super(problems.stream().map(PlainText::line).collect(Collectors.joining("\n")));
    }
}
