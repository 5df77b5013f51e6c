package org.dronewatch.setting;

/**
 * Something that a person gave to the program is wrong: a file, a field, an option. The message is one line that names
 * the place, the value and the limit, and is shown as it is.
 */
public final class InputException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** A problem described in one line. */
    public InputException(String message) {
        super(oneLine(message));
    }

    /** A problem described in one line, with what caused it. */
    public InputException(String message, Throwable cause) {
        super(oneLine(message), cause);
    }

    private static String oneLine(String message) {
        return message.replaceAll("\\p{Cntrl}+", " ").strip();
    }
}
