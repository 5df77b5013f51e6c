package org.dronewatch.app.console;

/** Exit codes of commands; 0 means that a command has done what was asked. */
public final class ExitCode {
    /** The command failed for a reason that no other code covers. */
    public static final int FAILED = 1;
    /** Wrong usage, or bad input. */
    public static final int BAD_INPUT = 2;
    /** The command needs a display, and there is none. */
    public static final int NO_DISPLAY = 3;

    private ExitCode() {}
}
