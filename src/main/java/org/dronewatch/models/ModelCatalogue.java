package org.dronewatch.models;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/** The models that are packaged with the library, and the files they consist of. */
public enum ModelCatalogue {
    /** Terrain of 1.5 km by 1.5 km. */
    HILL(() -> new HillTerrain().mesh()),
    /** The drone of the packaged scenes. */
    QUADROTOR(QuadrotorModel::mesh),
    /** A fixed-wing aircraft with a propeller. */
    FIXED_WING(FixedWingModel::mesh),
    /** A glider with lift rotors. */
    HYBRID_GLIDER(HybridGliderModel::mesh),
    /** A house with a roof platform. */
    HOUSE(HouseModel::mesh),
    /** The inside of a church. */
    CATHEDRAL(CathedralModel::mesh);

    private final Supplier<Mesh> maker;

    ModelCatalogue(Supplier<Mesh> maker) {
        this.maker = maker;
    }

    /** Makes the model; the same every time. */
    public Mesh mesh() {
        return maker.get();
    }

    /** The model's files by name: an OBJ and its MTL, identical byte for byte every time. */
    public static Map<String, byte[]> files(Mesh mesh) {
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put(mesh.name() + ".obj", ObjWriter.obj(mesh).getBytes(StandardCharsets.US_ASCII));
        files.put(mesh.name() + ".mtl", ObjWriter.mtl(mesh).getBytes(StandardCharsets.US_ASCII));
        return files;
    }

    /** All models, in the order in which they are listed. */
    public static List<ModelCatalogue> all() {
        return List.of(values());
    }
}
