package org.dronewatch.app.console;

/** Exit codes of commands; 0 is that of one that has done what was asked. */
public final class ExitCode {
    /** Of anything else that went wrong. */
    public static final int FAILED = 1;
    /** Of wrong usage and bad input. */
    public static final int BAD_INPUT = 2;
    /** Of a command that needs a display where there is none. */
    public static final int NO_DISPLAY = 3;

    private ExitCode() {}
}
