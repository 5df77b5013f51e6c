package org.dronewatch.scenario;

/** What people read about settings records and their components: the words of their Javadoc. */
public interface SettingTexts {

    /** The first sentence on a record; empty when nothing is said. */
    String summary(Class<?> record);

    /** What a component of a record is; empty when nothing is said. */
    String part(Class<?> record, String component);
}
