package org.dronewatch.setting;

import java.util.List;

/** A {@link Kind} with these properties. */
record PlainKind<T>(
        Class<? super T> type, String name, Class<? extends T> settings, String summary, List<String> synonyms)
        implements Kind<T> {}
