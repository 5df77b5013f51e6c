package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a component of a settings record that holds entries by name, each of which can be switched off, whatever the
 * type of its record: with {@code enabled: false} among the settings of the entry, or by the path of an override, such
 * as {@code sensors.roof.enabled}. Disabled names are kept in another component of the record (a set of strings) that
 * does not appear in files. {@code enabled} is reserved: an entry's record cannot have a component of that name.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Switchable {
    /** The key in the file. */
    String ENABLED = "enabled";

    /** The component that holds the disabled names. */
    String value();
}
