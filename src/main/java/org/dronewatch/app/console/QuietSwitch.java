package org.dronewatch.app.console;

/** A command with a switch that limits what is printed to results, warnings and errors. */
public interface QuietSwitch {
    /** Whether the user has set the switch. */
    boolean isQuiet();
}
