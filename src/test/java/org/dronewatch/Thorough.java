package org.dronewatch;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Tag;

/**
 * A test that takes long, while others in less time find most of what it would: {@code mvn verify} leaves it out, to
 * take no longer than ten minutes. {@code mvn test -Pthorough} runs all of these tests, as the CI does, and
 * {@code -Dtest=NAME} those of one class.
 */
@Tag("thorough")
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
public @interface Thorough {}
