package org.dronewatch.setting;

/** A {@link Kind} of four values. */
record PlainKind<T>(Class<? super T> type, String name, Class<? extends T> settings, String summary)
        implements Kind<T> {}
