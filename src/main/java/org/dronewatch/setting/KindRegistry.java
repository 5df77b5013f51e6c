package org.dronewatch.setting;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.Supplier;

/**
 * The kinds on the class path: first those of the library, then all others by type and name, so that the order of the
 * jars does not matter. Immutable.
 */
public final class KindRegistry {
    private static KindRegistry found;

    private final List<FoundKind> all;
    private final Map<Class<?>, Map<String, Class<?>>> byType = new LinkedHashMap<>();

    /**
     * A registry of the given kinds.
     *
     * @throws InputException when two kinds of a type have the same name; the message, of one line, gives both origins
     */
    KindRegistry(List<FoundKind> found) {
        all = new ArrayList<>(found);
        all.sort(Comparator.comparing((FoundKind one) -> !one.builtIn())
                .thenComparing(one -> one.builtIn() ? "" : one.kind().type().getName())
                .thenComparing(one -> one.builtIn() ? "" : one.kind().name()));
        for (FoundKind one : all) {
            Class<?> former = byType.computeIfAbsent(one.kind().type(), type -> new LinkedHashMap<>())
                    .putIfAbsent(one.kind().name(), one.kind().settings());
            if (former != null) {
                throw new InputException(twice(one));
            }
        }
    }

    private String twice(FoundKind one) {
        List<String> places = all.stream()
                .filter(other -> other.kind().type() == one.kind().type())
                .filter(other -> other.kind().name().equals(one.kind().name()))
                .map(FoundKind::source)
                .toList();
        boolean taken = all.stream()
                .anyMatch(other -> other.builtIn()
                        && other.kind().type() == one.kind().type()
                        && other.kind().name().equals(one.kind().name()));
        return "kind '" + one.kind().name() + "' of " + one.kind().type().getSimpleName() + " is in "
                + String.join(" and in ", places)
                + (taken
                        ? ": the names of built-in kinds are reserved: rename the other one, or remove it from the class path"
                        : ": remove one of them from the class path");
    }

    /**
     * The kinds of this program's class path; the search runs once.
     *
     * @throws InputException when a provider cannot be loaded or declares an invalid kind, or when a name is duplicated
     */
    public static synchronized KindRegistry found() {
        if (found == null) {
            found = new KindRegistry(load(loader()));
        }
        return found;
    }

    private static ClassLoader loader() {
        ClassLoader mine = Thread.currentThread().getContextClassLoader();
        return mine == null ? Kind.class.getClassLoader() : mine;
    }

    /** The kinds offered by the providers visible to a class loader. */
    static List<FoundKind> load(ClassLoader loader) {
        List<FoundKind> found = new ArrayList<>();
        for (KindGroup group : providers(KindGroup.class, loader)) {
            found.addAll(kindsOf(group, group::kinds));
        }
        for (Kind<?> kind : providers(Kind.class, loader)) {
            found.addAll(kindsOf(kind, () -> List.of(kind)));
        }
        return found;
    }

    /** What a provider offers; code of other jars, which may fail. */
    private static List<FoundKind> kindsOf(Object provider, Supplier<List<? extends Kind<?>>> offer) {
        try {
            return offer.get().stream()
                    .map(kind -> FoundKind.by(provider, kind))
                    .toList();
        } catch (InputException e) {
            throw e;
        } catch (RuntimeException | LinkageError e) {
            throw new InputException(
                    "class path: provider " + provider.getClass().getName() + " from "
                            + FoundKind.placeOf(provider.getClass()) + " fails: " + PlainText.value(e.toString()),
                    e);
        }
    }

    /**
     * All providers of a service on the class path.
     *
     * @throws InputException when one cannot be loaded
     */
    public static <S> List<S> providers(Class<S> service) {
        return providers(service, loader());
    }

    private static <S> List<S> providers(Class<S> service, ClassLoader loader) {
        List<S> providers = new ArrayList<>();
        ProviderFiles.of(service, loader).checkDuplicates();
        try {
            Iterator<S> each = ServiceLoader.load(service, loader).iterator();
            while (each.hasNext()) {
                providers.add(each.next());
            }
        } catch (ServiceConfigurationError | LinkageError e) {
            throw new InputException("class path: " + PlainText.value(String.valueOf(e.getMessage())), e);
        }
        return providers;
    }

    /** All kinds, in the order in which they are listed. */
    public List<FoundKind> all() {
        return Collections.unmodifiableList(all);
    }

    /** Whether there are kinds of a type. */
    public boolean knows(Class<?> type) {
        return byType.containsKey(type);
    }

    /**
     * The name of the kind of a type that has the given {@linkplain Kind#synonyms synonym}, in upper or lower case;
     * empty if there is none.
     */
    public Optional<String> byAnotherWord(Class<?> type, String word) {
        return all.stream()
                .map(FoundKind::kind)
                .filter(kind -> kind.type() == type)
                .filter(kind -> kind.synonyms().contains(word.toLowerCase(Locale.ROOT)))
                .map(Kind::name)
                .findFirst();
    }

    /**
     * The kind that was probably meant by a mistyped name: one with this {@linkplain Kind#synonyms synonym}, or one
     * whose name is spelt similarly.
     *
     * @param names the names that may be meant
     */
    public Optional<String> meant(Class<?> type, String typed, Collection<String> names) {
        return byAnotherWord(type, typed).or(() -> Spelling.meant(typed, names));
    }

    /** The end of a message about an unknown kind of a type: where it may come from; empty if the type has no kinds. */
    public String otherJar(Class<?> type) {
        return knows(type) ? "; a kind from another jar needs that jar on the class path" : "";
    }

    /** The settings of the kinds of a type by name; none when it has no kinds. */
    public Map<String, Class<?>> of(Class<?> type) {
        return Collections.unmodifiableMap(byType.getOrDefault(type, Map.of()));
    }

    /** The kind with this class of settings; empty if there is none. */
    public Optional<Kind<?>> kindOf(Class<?> settings) {
        return all.stream()
                .<Kind<?>>map(FoundKind::kind)
                .filter(kind -> kind.settings() == settings)
                .findFirst();
    }
}
