package org.dronewatch.app.console;

/** What users may ask to print results, warnings and errors only. */
public interface QuietSwitch {
    /** Whether they have asked. */
    boolean isQuiet();
}
