package org.dronewatch.catalog;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;

/** Real positioners by name, for {@code positioner: {use: NAME}} of a camera. */
public final class Positioners implements Kinds.NamedSettings {
    private static final List<String> PACKAGED = List.of("viper");

    /** The names, in the order in which they are listed. */
    public static List<String> packagedNames() {
        return PACKAGED;
    }

    /** The entry of a positioner; empty when there is none of this name. */
    public Optional<CatalogEntry> entry(String name) {
        return PACKAGED.contains(name)
                ? Optional.of(Catalog.entryOf(Catalog.resource("positioner/" + name + ".yaml")))
                : Optional.empty();
    }

    @Override
    public Optional<Node.Mapping> find(String name) {
        return entry(name).map(CatalogEntry::sensor);
    }

    @Override
    public Set<String> names() {
        return new LinkedHashSet<>(PACKAGED);
    }
}
