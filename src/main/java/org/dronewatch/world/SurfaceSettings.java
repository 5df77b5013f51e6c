package org.dronewatch.world;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.InputException;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterials;

/**
 * The acoustic surfaces of the materials in the model files. A material that is not listed in {@code materials} but
 * whose name is that of a surface in {@code own} or in the library's table uses that surface; all others use the
 * {@code defaultSurface}. The part of a name after a colon is ignored: {@code brick_rough:assumed-height} uses the
 * surface {@code brick_rough}.
 *
 * @param materials the surfaces of the materials in the model files, by name of the material; each is the name of a
 *     surface from {@code own} or from the table
 * @param defaultSurface name of the surface for all other materials
 * @param own surfaces defined in the scene, by name; they replace those of the same name in the table
 */
public record SurfaceSettings(
        Map<String, String> materials, @Formerly("otherwise") String defaultSurface, Map<String, OwnSurface> own) {
    /**
     * No material is assigned a surface; all use the table's ordinary hard surface unless their own name is in the
     * table.
     */
    @Defaults
    public static final SurfaceSettings DEFAULT = new SurfaceSettings(Map.of(), SurfaceMaterials.SOLID, Map.of());

    /** Copies the maps. Names are checked by {@link #checkNames}, which {@link WorldSettings} calls. */
    public SurfaceSettings {
        materials = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("materials", materials)));
        Check.present("defaultSurface", defaultSurface);
        own = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("own", own)));
    }

    /**
     * Checks all names.
     *
     * @throws IllegalArgumentException when there is no surface with one of the names, or a surface defined in the
     *     scene has an empty name
     */
    public void checkNames() {
        if (own.containsKey("")) {
            throw new IllegalArgumentException("own: a surface needs a name, not ''");
        }
        materials.forEach((material, name) -> checkName("materials." + material, name));
        checkName("defaultSurface", defaultSurface);
    }

    private void checkName(String path, String name) {
        try {
            named(name);
        } catch (InputException e) {
            String also = own.isEmpty() ? "" : "; the scene defines " + String.join(", ", own.keySet());
            throw new IllegalArgumentException(path + ": " + e.getMessage() + also, e);
        }
    }

    private SurfaceMaterial named(String name) {
        return find(name).orElseGet(() -> SurfaceMaterials.get(name));
    }

    private Optional<SurfaceMaterial> find(String name) {
        return own.containsKey(name) ? Optional.of(own.get(name).material(name)) : SurfaceMaterials.find(name);
    }

    private Optional<SurfaceMaterial> assigned(String material) {
        return Optional.ofNullable(materials.get(material)).map(this::named).or(() -> find(material));
    }

    private static String withoutVariant(String material) {
        return material.replaceFirst(":.*", "");
    }

    /** These settings with a surface, from the scene or from the table, for one more material of the model files. */
    public SurfaceSettings with(String material, String surface) {
        Map<String, String> more = new LinkedHashMap<>(materials);
        more.put(material, surface);
        return new SurfaceSettings(more, defaultSurface, own);
    }

    /** These settings with one more surface defined in the scene. */
    public SurfaceSettings withOwn(String name, OwnSurface surface) {
        Map<String, OwnSurface> more = new LinkedHashMap<>(own);
        more.put(name, surface);
        return new SurfaceSettings(materials, defaultSurface, more);
    }

    /** The surface of a material of a model file. */
    public SurfaceMaterial of(String material) {
        return assigned(material).or(() -> assigned(withoutVariant(material))).orElseGet(() -> named(defaultSurface));
    }

    /** The given model materials without a known surface, to which the default surface applies. */
    public List<String> leftOver(List<String> materials) {
        return materials.stream()
                .filter(name -> assigned(name).isEmpty()
                        && assigned(withoutVariant(name)).isEmpty())
                .toList();
    }

    /** The materials that are assigned a surface, but are not among the given model materials. */
    public List<String> unmatched(List<String> materials) {
        return this.materials.keySet().stream()
                .filter(name -> !materials.contains(name)
                        && materials.stream()
                                .map(SurfaceSettings::withoutVariant)
                                .noneMatch(name::equals))
                .toList();
    }

    /** The surfaces defined in the scene that none of the given model materials uses. */
    public List<String> unused(List<String> materials) {
        Set<String> used = materials.stream().map(name -> of(name).name()).collect(Collectors.toSet());
        return own.keySet().stream().filter(name -> !used.contains(name)).toList();
    }
}
