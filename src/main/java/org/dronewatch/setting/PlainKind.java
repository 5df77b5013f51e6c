package org.dronewatch.setting;

/** A {@link Kind} with these four properties. */
record PlainKind<T>(Class<? super T> type, String name, Class<? extends T> settings, String summary)
        implements Kind<T> {}
