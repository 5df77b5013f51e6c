package org.dronewatch.setting.file;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dronewatch.setting.Choices;

/** The kinds of settings among which a file may choose, and the named settings on which it may build. Immutable. */
public final class Kinds {
    /** The kinds that sealed interfaces permit, and those found on the class path. */
    public static final Kinds FOUND = new Kinds(Map.of(), Map.of(), Map.of());

    private final Map<Class<?>, Map<String, Class<?>>> registered;
    private final Map<Class<?>, NamedSettings> named;
    private final Map<Class<?>, List<OtherForm>> others;

    /**
     * An alternative form in which files may give values of a type.
     *
     * @param parts record class with the components of the form as written
     * @param value converts the form to the value; empty when the value is unknown because of another mistake in the
     *     file. An {@link IllegalArgumentException} states a mistake in the form
     */
    public record OtherForm(Class<? extends Record> parts, Function<Record, Optional<?>> value) {}

    private Kinds(
            Map<Class<?>, Map<String, Class<?>>> registered,
            Map<Class<?>, NamedSettings> named,
            Map<Class<?>, List<OtherForm>> others) {
        this.registered = Map.copyOf(registered);
        this.named = Map.copyOf(named);
        this.others = Map.copyOf(others);
    }

    /** Named settings that a file may use and partly override. */
    public interface NamedSettings {
        /**
         * The settings with this name, as if they were written in the file; empty if there are none.
         *
         * @throws org.dronewatch.setting.InputException when they cannot be read
         */
        Optional<Node.Mapping> find(String name);

        /** All names. */
        Set<String> names();

        /**
         * The parts of the system with this name; empty unless the name is that of a system. A system consists of
         * several settings that are used together, for example those of a radar and of a camera.
         *
         * @return the parts by suffix: the name of a part is that of the system's entry in the file, followed by a
         *     hyphen and the suffix
         */
        default Map<String, Node.Mapping> partsOf(String name) {
            return Map.of();
        }
    }

    /** These kinds and those of one more interface, by the names used in files. */
    public Kinds with(Class<?> type, Map<String, Class<? extends Record>> kinds) {
        Map<Class<?>, Map<String, Class<?>>> more = new LinkedHashMap<>(registered);
        more.put(type, new LinkedHashMap<>(kinds));
        return new Kinds(more, named, others);
    }

    /** These kinds, with named settings for an interface. */
    public Kinds with(Class<?> type, NamedSettings settings) {
        Map<Class<?>, NamedSettings> more = new LinkedHashMap<>(named);
        more.put(type, settings);
        return new Kinds(registered, more, others);
    }

    /**
     * These kinds, with an alternative form in which files may give values of a type: a record whose components have
     * names different from those of the type.
     *
     * @param value converts the form to the value; empty when the value is unknown because of another mistake in the
     *     file
     */
    public <T, F extends Record> Kinds with(Class<T> type, Class<F> parts, Function<F, Optional<T>> value) {
        List<OtherForm> forms = new ArrayList<>(otherForms(type));
        forms.add(new OtherForm(parts, written -> value.apply(parts.cast(written))));
        Map<Class<?>, List<OtherForm>> more = new LinkedHashMap<>(others);
        more.put(type, List.copyOf(forms));
        return new Kinds(registered, named, more);
    }

    /** The alternative forms in which files may give values of a type. */
    public List<OtherForm> otherForms(Class<?> type) {
        return others.getOrDefault(type, List.of());
    }

    /** Whether any kinds of a type are known. */
    public boolean isChoice(Class<?> type) {
        return registered.containsKey(type) || Choices.isChoice(type);
    }

    /** The kinds of a type by name. */
    public Map<String, Class<?>> of(Class<?> type) {
        return registered.containsKey(type) ? registered.get(type) : Choices.of(type);
    }

    /** The named settings for a type; empty if there are none. */
    public Optional<NamedSettings> named(Class<?> type) {
        return Optional.ofNullable(named.get(type));
    }
}
