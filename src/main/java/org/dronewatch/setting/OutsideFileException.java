package org.dronewatch.setting;

/**
 * Reports that a settings file cannot name a file that is neither in the directory of the settings file nor below it.
 */
public final class OutsideFileException extends InputException {
    private static final long serialVersionUID = 1L;

    private final String fact;

    /**
     * A problem described in one line, and its solution.
     *
     * @param fact what the problem is
     * @param advice what to do about it; commands that also write other files give different advice
     */
    public OutsideFileException(String fact, String advice) {
        super(fact + ": " + advice);
        this.fact = PlainText.line(fact);
    }

    /** What the problem is, without advice. */
    public String fact() {
        return fact;
    }
}
