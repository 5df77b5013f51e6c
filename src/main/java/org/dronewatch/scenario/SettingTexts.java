package org.dronewatch.scenario;

/** Human-readable descriptions of settings records and their components, taken from their Javadoc. */
public interface SettingTexts {

    /** The first sentence of a record's description; empty if it has none. */
    String summary(Class<?> record);

    /** The description of a record component; empty if it has none. */
    String part(Class<?> record, String component);
}
