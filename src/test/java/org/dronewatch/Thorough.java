package org.dronewatch;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;

/**
 * A test that takes seconds: {@code mvn verify} leaves it out, to take no longer than ten minutes, so some behaviour
 * is checked by {@code mvn test -Pthorough} alone, which runs all of these tests, as the CI does, and
 * {@code -Dtest=NAME} those of one class.
 */
@Tag("thorough")
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
public @interface Thorough {}
