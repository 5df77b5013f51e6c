package org.dronewatch.analysis.layer;

import java.lang.reflect.RecordComponent;
import java.security.CodeSource;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.SettingsForm;

/**
 * Finds out whether settings are of this program's own kinds, whose code is part of the key under which results are
 * kept.
 */
final class OwnCode {
    private static final CodeSource HERE = OwnCode.class.getProtectionDomain().getCodeSource();

    private OwnCode() {}

    /** Whether a value and all that it consists of are of classes of this program or of Java itself. */
    static boolean isAll(Object value) {
        if (value instanceof Optional<?> optional) {
            return optional.map(OwnCode::isAll).orElse(true);
        }
        if (value instanceof Collection<?> all) {
            return all.stream().allMatch(OwnCode::isAll);
        }
        if (value instanceof Map<?, ?> map) {
            return map.values().stream().allMatch(OwnCode::isAll);
        }
        if (value == null || value.getClass().isArray()) {
            return true;
        }
        if (!isOwn(value.getClass())) {
            return false;
        }
        if (value instanceof Record record) {
            for (RecordComponent part : record.getClass().getRecordComponents()) {
                if (!isAll(SettingsForm.get(record, part))) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean isOwn(Class<?> type) {
        CodeSource source = type.getProtectionDomain().getCodeSource();
        return source == null
                ? type.getClassLoader() == null || type.getClassLoader() == ClassLoader.getPlatformClassLoader()
                : HERE != null && String.valueOf(source.getLocation()).equals(String.valueOf(HERE.getLocation()));
    }
}
