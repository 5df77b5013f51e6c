package org.dronewatch.app;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import org.slf4j.LoggerFactory;

/** Keeps the libraries' logs off standard output, which carries results only. */
final class Logging {

    private Logging() {}

    /** Removes the appenders that write to the console; real failures reach the user as exceptions. */
    static void silence() {
        if (LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME) instanceof Logger root) {
            root.detachAndStopAllAppenders();
            root.getLoggerContext().getLoggerList().forEach(logger -> {
                logger.detachAndStopAllAppenders();
                logger.setLevel(Level.OFF);
            });
        }
    }
}
