package org.dronewatch.setting.file;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;

/**
 * Makes settings records from nodes. Errors are collected and reading continues, so that everything else is checked,
 * too.
 */
final class SettingsReader {
    /** Stands for a value that could not be read; a problem says why. */
    private static final Object FAILED = new Object();

    private final Kinds kinds;
    private final FileNames files;
    private final KindChooser chooser;
    private final OtherForms others;
    private final FormerNameReader formerNames;
    private final Problems problems;
    /** Paths of settings that can be switched off. */
    private final Set<String> switchable = new HashSet<>();

    /**
     * A reader.
     *
     * @param used receives the settings that are written under a former name
     */
    SettingsReader(Kinds kinds, Path directory, FormerNames used, Problems problems) {
        this.kinds = kinds;
        this.files = new FileNames(directory);
        this.formerNames = new FormerNameReader(used, problems);
        this.chooser = new KindChooser(kinds, problems);
        this.others = new OtherForms(kinds, problems);
        this.problems = problems;
    }

    /** Settings of a document; empty when there are problems. */
    Optional<Object> read(Class<?> type, Node.Mapping document) {
        Object settings = read(type, Quantity.NUMBER, document, "");
        return settings == FAILED ? Optional.empty() : Optional.of(settings);
    }

    private Object read(Type type, Quantity quantity, Node node, String path) {
        if (node instanceof Node.Scalar scalar && scalar.text().isEmpty()) {
            return failed(node, path, "is empty");
        }
        if (node instanceof Node.Ready ready) {
            return ready.value();
        }
        if (type instanceof ParameterizedType parameterized) {
            return several(parameterized, quantity, node, path);
        }
        Class<?> plain = (Class<?>) type;
        if (node instanceof Node.Scalar scalar) {
            return isKnownByOnePart(plain)
                    ? record(SettingsForm.of(plain), onePart(SettingsForm.of(plain), scalar), path)
                    : single(plain, quantity, scalar, path);
        }
        if (node instanceof Node.Sequence sequence) {
            return numbers(plain, sequence, path);
        }
        Node.Mapping mapping = (Node.Mapping) node;
        if (plain == Node.Mapping.class) {
            return mapping;
        }
        if (kinds.isChoice(plain)) {
            return choice(plain, mapping, path);
        }
        Optional<Kinds.OtherForm> other = others.of(plain, mapping);
        if (other.isPresent()) {
            Object written = record(SettingsForm.of(other.get().parts()), mapping, path);
            return written == FAILED
                    ? FAILED
                    : others.value(other.get(), written, mapping, path).orElse(FAILED);
        }
        if (plain.isRecord()) {
            return chooser.withReadySettings(plain, mapping, path)
                    .map(whole -> record(SettingsForm.of(plain), whole, path))
                    .orElse(FAILED);
        }
        return failed(node, path, "must be a single value");
    }

    /** Whether a single value may stand for a record, because all its other parts have defaults. */
    private static boolean isKnownByOnePart(Class<?> type) {
        return type.isRecord()
                && !SettingsForm.of(type).isNumbers()
                && SettingsForm.of(type).required().size() == 1;
    }

    private static Node.Mapping onePart(SettingsForm form, Node.Scalar scalar) {
        String name = form.required().get(0);
        return Node.Mapping.of(Map.of(name, scalar), Map.of(name, scalar.mark()), scalar.mark());
    }

    private Object failed(Node node, String path, String message) {
        problems.add(node.mark(), path, message);
        return FAILED;
    }

    private Object single(Class<?> type, Quantity quantity, Node.Scalar node, String path) {
        Optional<Kinds.NamedSettings> named = kinds.named(type);
        if (named.isPresent()) {
            return failed(
                    node,
                    path,
                    "must be named settings, as in '" + KindChooser.USE + ": "
                            + named.get().names().stream().findFirst().orElse("NAME") + "'");
        }
        try {
            return SettingText.parse(type, quantity, node.text());
        } catch (IllegalArgumentException e) {
            return failed(node, path, e.getMessage());
        }
    }

    private Object numbers(Class<?> type, Node.Sequence sequence, String path) {
        if (!type.isRecord() || !SettingsForm.of(type).isNumbers()) {
            return failed(sequence, path, "must not be a list");
        }
        List<String> texts = new ArrayList<>();
        for (Node item : sequence.items()) {
            if (!(item instanceof Node.Scalar scalar)) {
                return failed(item, path, "must be a number");
            }
            texts.add(scalar.text());
        }
        try {
            return SettingText.numbers(SettingsForm.of(type), texts);
        } catch (IllegalArgumentException e) {
            return failed(sequence, path, e.getMessage());
        }
    }

    private Object several(ParameterizedType type, Quantity quantity, Node node, String path) {
        Type[] inner = type.getActualTypeArguments();
        if (type.getRawType() == Optional.class) {
            Object value = read(inner[0], quantity, node, path);
            return value == FAILED ? FAILED : Optional.of(value);
        }
        if (type.getRawType() == List.class) {
            return node instanceof Node.Sequence sequence
                    ? list(inner[0], quantity, sequence, path)
                    : failed(node, path, "must be a list, as in [a, b], or lines that begin with '-'");
        }
        if (type.getRawType() == Map.class) {
            return node instanceof Node.Mapping mapping
                    ? map(inner[1], quantity, mapping, path)
                    : failed(node, path, "must be named values, one per line, as in 'name: value'");
        }
        // A class with a type parameter, such as the settings of a sensor of any kind.
        return read(type.getRawType(), quantity, node, path);
    }

    private Object list(Type type, Quantity quantity, Node.Sequence sequence, String path) {
        List<Object> values = new ArrayList<>();
        for (Node item : sequence.items()) {
            values.add(read(type, quantity, item, path + "." + values.size()));
        }
        return values.contains(FAILED) ? FAILED : values;
    }

    private Object map(Type type, Quantity quantity, Node.Mapping mapping, String path) {
        Map<String, Object> values = new LinkedHashMap<>();
        mapping.values().forEach((name, node) -> values.put(name, read(type, quantity, node, path + "." + name)));
        return values.containsValue(FAILED) ? FAILED : values;
    }

    private Object choice(Class<?> type, Node.Mapping written, String path) {
        return chooser.choose(type, written, path)
                .map(chosen -> record(chosen.form(), chosen.parts(), path))
                .orElse(FAILED);
    }

    private Object record(SettingsForm form, Node.Mapping written, String path) {
        int before = problems.count();
        Node.Mapping mapping = formerNames.read(form, written, path);
        Map<String, Object> values = new LinkedHashMap<>();
        mapping.values().forEach((name, node) -> {
            String field = path.isEmpty() ? name : path + "." + name;
            Optional<RecordComponent> part = form.part(name);
            if (part.isEmpty()) {
                problems.unknownSetting(
                        mapping.keys().get(name),
                        path,
                        name,
                        form,
                        switchable.contains(path) ? List.of(Switchable.ENABLED) : List.of());
                return;
            }
            if (others.isRefused(part.get(), node, field)) {
                return;
            }
            Object value = read(
                    part.get().getGenericType(),
                    SettingText.quantity(part.get()),
                    switched(
                            form,
                            part.get(),
                            new NamedGroups(kinds, problems).expanded(part.get(), node, field),
                            field,
                            values),
                    field);
            if (value != FAILED && fits(part.get(), node, value, field)) {
                values.put(name, value);
            }
        });
        for (String name : form.required()) {
            if (!mapping.values().containsKey(name)) {
                problems.add(mapping.mark(), path, "needs '" + name + "'");
            }
        }
        if (!values.keySet().containsAll(form.required())) {
            return FAILED;
        }
        if (problems.count() > before) {
            new RejectedParts(problems, form, mapping, values, path).report();
            return FAILED;
        }
        try {
            return form.create(values);
        } catch (IllegalArgumentException e) {
            if (!new RejectedParts(problems, form, mapping, values, path).report()) {
                problems.add(mapping.markOf(e.getMessage()), path, e.getMessage());
            }
            return FAILED;
        }
    }

    /** The entries of a component without their switches, which become another component's value. */
    private Node switched(
            SettingsForm form, RecordComponent part, Node node, String field, Map<String, Object> values) {
        if (!part.isAnnotationPresent(Switchable.class) || !(node instanceof Node.Mapping all)) {
            return node;
        }
        all.values().keySet().forEach(name -> switchable.add(field + "." + name));
        SwitchReader switches = new SwitchReader(problems);
        Node rest = switches.read(all, field);
        values.put(form.switchOf(part).getName(), switches.off());
        return rest;
    }

    private boolean fits(RecordComponent part, Node node, Object value, String field) {
        try {
            Limits.check(part, value);
        } catch (IllegalArgumentException e) {
            Optional<String> inItsUnit =
                    node instanceof Node.Scalar scalar ? Limits.refusal(part, scalar.text()) : Optional.empty();
            problems.add(node.mark(), field, inItsUnit.orElse(e.getMessage()));
            return false;
        }
        FileName rule = part.getAnnotation(FileName.class);
        return rule == null || files.areThere(rule, node, value, field, problems);
    }
}
