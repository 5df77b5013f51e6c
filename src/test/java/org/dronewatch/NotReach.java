package org.dronewatch;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaType;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Some types cannot be reached from a class: neither its fields nor the parameters and results of its methods are of
 * such a type or have one as a type argument, nor those of these types in turn, of their parents and of their children.
 */
final class NotReach extends ArchCondition<JavaClass> {
    private final Set<Class<?>> forbidden;

    NotReach(Set<Class<?>> forbidden) {
        super("not reach %s", forbidden);
        this.forbidden = forbidden;
    }

    @Override
    public void check(JavaClass from, ConditionEvents events) {
        Map<JavaClass, String> paths = new HashMap<>();
        Deque<JavaClass> open = new ArrayDeque<>();
        paths.put(from, from.getSimpleName());
        open.add(from);
        while (!open.isEmpty()) {
            JavaClass one = open.remove();
            for (JavaClass next : neighbours(one)) {
                String path = paths.get(one) + " > " + next.getSimpleName();
                if (isOurs(next) && paths.putIfAbsent(next, path) == null) {
                    open.add(next);
                }
            }
        }
        boolean isFree = true;
        for (Map.Entry<JavaClass, String> reached : paths.entrySet()) {
            if (forbidden.stream().anyMatch(reached.getKey()::isEquivalentTo)) {
                isFree = false;
                events.add(SimpleConditionEvent.violated(from, reached.getValue()));
            }
        }
        if (isFree) {
            events.add(SimpleConditionEvent.satisfied(from, paths.size() + " types reached"));
        }
    }

    private static boolean isOurs(JavaClass type) {
        return type.getPackageName().startsWith("org.dronewatch");
    }

    private static Set<JavaClass> neighbours(JavaClass type) {
        Set<JavaClass> all = new HashSet<>(type.getAllRawInterfaces());
        all.addAll(type.getAllRawSuperclasses());
        all.addAll(type.getAllSubclasses());
        for (JavaField field : type.getFields()) {
            all.addAll(field.getType().getAllInvolvedRawTypes());
        }
        for (JavaCodeUnit unit : type.getCodeUnits()) {
            all.addAll(unit.getReturnType().getAllInvolvedRawTypes());
            for (JavaType parameter : unit.getParameterTypes()) {
                all.addAll(parameter.getAllInvolvedRawTypes());
            }
        }
        return all;
    }
}
