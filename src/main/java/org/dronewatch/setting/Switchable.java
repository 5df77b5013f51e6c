package org.dronewatch.setting;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a component of a settings record that holds settings by name, each of which can be switched off: people write
 * {@code enabled: false} among its settings, or set {@code NAME.enabled}, whatever its record is. The names of those that are
 * off are kept in another component of the record, a set of texts, which people do not write. The word {@code enabled} is the
 * switch in each of them: a component of that name in a record that is held cannot be written.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Switchable {
    /** What people write. */
    String ENABLED = "enabled";

    /** The component that holds the names of those that are off. */
    String value();
}
