package org.dronewatch.world;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.InputException;
import org.dronewatch.sound.SurfaceMaterial;
import org.dronewatch.sound.SurfaceMaterials;

/**
 * The acoustic surfaces of the materials in the model files. A material that is not listed here but whose name is in
 * the table of surfaces uses that entry; all others use the {@code defaultSurface}.
 *
 * @param materials names in the table of surfaces, by names of materials in the model files
 * @param defaultSurface name in the table of surfaces for all other materials
 */
public record SurfaceSettings(Map<String, String> materials, @Formerly("otherwise") String defaultSurface) {
    /** No material is assigned a surface; all use the table's ordinary hard surface unless their own name is in the table. */
    @Defaults
    public static final SurfaceSettings DEFAULT = new SurfaceSettings(Map.of(), SurfaceMaterials.SOLID);

    /**
     * Looks all names up and keeps its own map.
     *
     * @throws IllegalArgumentException when the table has no such name
     */
    public SurfaceSettings {
        materials = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("materials", materials)));
        Check.present("defaultSurface", defaultSurface);
        try {
            materials.values().forEach(SurfaceMaterials::get);
            SurfaceMaterials.get(defaultSurface);
        } catch (InputException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /** These settings with a surface for one more material of the model files. */
    public SurfaceSettings with(String ofTheModel, String ofTheTable) {
        Map<String, String> more = new LinkedHashMap<>(materials);
        more.put(ofTheModel, ofTheTable);
        return new SurfaceSettings(more, defaultSurface);
    }

    /** The surface of a material of a model file. */
    public SurfaceMaterial of(String ofTheModel) {
        String name = materials.get(ofTheModel);
        if (name != null) {
            return SurfaceMaterials.get(name);
        }
        return SurfaceMaterials.find(ofTheModel).orElseGet(() -> SurfaceMaterials.get(defaultSurface));
    }

    /** Of the given model materials, those without a known surface, to which the default surface applies. */
    public List<String> leftOver(List<String> ofTheModels) {
        return ofTheModels.stream()
                .filter(name -> !materials.containsKey(name)
                        && SurfaceMaterials.find(name).isEmpty())
                .toList();
    }
}
