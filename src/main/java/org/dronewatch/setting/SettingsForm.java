package org.dronewatch.setting;

import java.lang.reflect.AccessibleObject;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The form of a settings record: its components, required or with their defaults (see {@link Defaults}). The form
 * creates records through their own constructors, so that all limits are checked.
 */
public final class SettingsForm {
    private static final ClassValue<SettingsForm> FORMS = new ClassValue<>() {
        @Override
        protected SettingsForm computeValue(Class<?> type) {
            return new SettingsForm(type);
        }
    };

    private final Class<?> type;
    private final List<RecordComponent> parts;
    private final Constructor<?> constructor;
    private final Field constant;
    private final Method factory;
    private final List<String> required;
    private final Set<String> hidden;
    private final Map<String, String> renamed;

    private SettingsForm(Class<?> type) {
        this.type = type;
        this.parts = List.of(type.getRecordComponents());
        Class<?>[] types = parts.stream().map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            this.constructor = opened(type.getDeclaredConstructor(types));
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException("record " + type.getName() + " has no canonical constructor", e);
        }
        this.hidden = parts.stream()
                .filter(part -> part.isAnnotationPresent(Switchable.class))
                .map(part -> part.getAnnotation(Switchable.class).value())
                .collect(Collectors.toUnmodifiableSet());
        this.renamed = Renames.of(type);
        this.constant = marked(List.of(type.getDeclaredFields()));
        this.factory = marked(List.of(type.getDeclaredMethods()));
        if (constant != null) {
            this.required = List.of();
        } else if (factory != null) {
            this.required = List.of(factory.getAnnotation(Defaults.class).value());
        } else {
            this.required = parts.stream().map(RecordComponent::getName).toList();
        }
    }

    /** The static member that is marked as giving defaults, or null. */
    private static <M extends AccessibleObject & Member> M marked(List<M> members) {
        return members.stream()
                .filter(member ->
                        member.isAnnotationPresent(Defaults.class) && Modifier.isStatic(member.getModifiers()))
                .findFirst()
                .map(SettingsForm::opened)
                .orElse(null);
    }

    /** Makes a member accessible: settings records of users may be private. */
    private static <M extends AccessibleObject> M opened(M member) {
        member.setAccessible(true);
        return member;
    }

    /**
     * The form of a record class.
     *
     * @throws IllegalArgumentException when the class is not a record
     * @throws IllegalStateException when a former name of a component is also a name of another one
     */
    public static SettingsForm of(Class<?> record) {
        if (!record.isRecord()) {
            throw new IllegalArgumentException(record.getName() + " is not a record");
        }
        return FORMS.get(record);
    }

    /** The record class. */
    public Class<?> type() {
        return type;
    }

    /** All components that can be written in files, in their order. */
    public List<RecordComponent> parts() {
        return hidden.isEmpty()
                ? parts
                : parts.stream()
                        .filter(part -> !hidden.contains(part.getName()))
                        .toList();
    }

    /** The component with this name; empty if there is none that can be written in files. */
    public Optional<RecordComponent> part(String name) {
        return parts().stream().filter(part -> part.getName().equals(name)).findFirst();
    }

    /** The names of all components that can be written in files, in their order. */
    public List<String> names() {
        return parts().stream().map(RecordComponent::getName).toList();
    }

    /**
     * The current names of components that had other names in earlier versions, by the earlier names; see
     * {@link Formerly}.
     */
    public Map<String, String> renamed() {
        return renamed;
    }

    /** The current name for a former one; any other name is returned unchanged. */
    public String currentName(String name) {
        return renamed.getOrDefault(name, name);
    }

    /**
     * A question for the end of a message about an unknown name, {@code ; did you mean 'fov'?}, with the current name
     * of the component that was probably meant; empty if no name is similar enough.
     *
     * @param others other names that are valid where this one was typed
     */
    public String didYouMean(String typed, Collection<String> others) {
        List<String> known = new ArrayList<>(names());
        known.addAll(others);
        known.addAll(renamed.keySet());
        return Spelling.meant(typed, known)
                .map(name -> Spelling.question(currentName(name)))
                .orElse("");
    }

    /** The component that holds the disabled names of a {@link Switchable} component. */
    public RecordComponent switchOf(RecordComponent switchable) {
        String name = switchable.getAnnotation(Switchable.class).value();
        return parts.stream()
                .filter(part -> part.getName().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalStateException(type.getName() + " has no component " + name));
    }

    /** The names of the components that have no default. */
    public List<String> required() {
        return required;
    }

    /** Whether the record consists of numbers only, so that it may be written as a list. */
    public boolean isNumbers() {
        return parts.stream().allMatch(part -> part.getType() == double.class);
    }

    /** Whether all components have defaults. */
    public boolean isCompleteByDefault() {
        return required.isEmpty();
    }

    /** Whether a component has the value that it gets when a file omits it. */
    public boolean isDefault(Record settings, RecordComponent part) {
        if (required.contains(part.getName())) {
            return false;
        }
        Map<String, Object> stated = new HashMap<>();
        parts.stream()
                .filter(one -> required.contains(one.getName()))
                .forEach(one -> stated.put(one.getName(), get(settings, one)));
        return get(settings, part).equals(get(byDefault(stated), part));
    }

    /** The value of a component. */
    public static Object get(Record settings, RecordComponent part) {
        try {
            return opened(part.getAccessor()).invoke(settings);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("settings component " + part + " cannot be read", e);
        }
    }

    /**
     * Creates a record.
     *
     * @param values values by name of the component: those of all required components, and of any others
     * @throws IllegalArgumentException when a limit is violated
     */
    public Record create(Map<String, Object> values) {
        if (constant == null && factory == null) {
            return construct(
                    parts.stream().map(part -> values.get(part.getName())).toArray());
        }
        return changed(byDefault(values), values);
    }

    /** The record with default values for all but the required components. */
    private Record byDefault(Map<String, Object> values) {
        try {
            if (constant != null) {
                return (Record) constant.get(null);
            }
            return (Record)
                    factory.invoke(null, required.stream().map(values::get).toArray());
        } catch (InvocationTargetException e) {
            throw limit(e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("defaults of settings " + type.getName() + " cannot be made", e);
        }
    }

    /**
     * A copy of a record with one component changed, for the {@code with...} methods of settings.
     *
     * @param part name of a component
     * @throws IllegalArgumentException when a limit is violated, or the record has no such component
     */
    public static <R extends Record> R with(R settings, String part, Object value) {
        return with(settings, Collections.singletonMap(part, value));
    }

    /**
     * A copy of a record with several components changed at once, so that limits that relate them to each other are
     * checked only for the result.
     *
     * @param values values by name of the component
     * @throws IllegalArgumentException when a limit is violated, or the record has no such component
     */
    @SuppressWarnings("unchecked")
    public static <R extends Record> R with(R settings, Map<String, ?> values) {
        SettingsForm form = of(settings.getClass());
        values.keySet().forEach(form::checkPart);
        return (R) form.changed(settings, values);
    }

    private void checkPart(String name) {
        if (parts.stream().noneMatch(part -> part.getName().equals(name))) {
            throw new IllegalArgumentException(type.getName() + " has no component " + name);
        }
    }

    private Record changed(Record settings, Map<String, ?> values) {
        return construct(parts.stream()
                .map(part -> values.containsKey(part.getName()) ? values.get(part.getName()) : get(settings, part))
                .toArray());
    }

    private Record construct(Object... values) {
        try {
            return (Record) constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            throw limit(e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("settings record " + type.getName() + " cannot be made", e);
        }
    }

    private static IllegalArgumentException limit(InvocationTargetException e) {
        if (e.getCause() instanceof Error error) {
            throw error;
        }
        return new IllegalArgumentException(e.getCause().getMessage(), e.getCause());
    }
}
