package org.dronewatch.mesh.io;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.AsNumbers;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A model file and its placement. The model is first moved so that the file's {@code origin} is at zero, then rotated
 * to stand upright, scaled, rotated to its heading, and moved to its position, all in double precision.
 *
 * @param file path of a model file, such as an .obj file, or {@code packaged:NAME} for a model of the library
 * @param upAxis axis of the file that points up
 * @param scale length of the file's unit, 1e-6 to 1e6 m
 * @param origin point of the file that is placed at {@code position}, in the file's unit and along its axes; for a file
 *     in coordinates of a national grid, use a point on the site, so that no precision is lost when coordinates are
 *     stored as floats
 * @param position position of the model's origin, m
 * @param heading rotation about the vertical, clockwise as seen from above, rad
 * @param role its role on the site, by which reports name the obstacles that hide drones; of no effect for a drone's
 *     model
 */
public record ModelSettings(
        @FileName(unless = ModelSettings.PACKAGED) String file,
        UpAxis upAxis,
        @In(value = Quantity.NUMBER, from = 1e-6, to = 1e6) double scale,
        @Minor FilePoint origin,
        @AsNumbers Position position,
        @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double heading,
        ModelRole role) {
    /** The prefix of the names of the library's models. */
    public static final String PACKAGED = "packaged:";

    private static final String HILL = PACKAGED + "hill.obj";

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public ModelSettings {
        Limits.check(ModelSettings.class, file, upAxis, scale, origin, position, heading, role);
        if (file.isBlank()) {
            throw new IllegalArgumentException("file is empty: it must name a model file");
        }
    }

    /**
     * A y-up file in metres, at the origin, as most OBJ files are; a building unless it is the packaged hill, which is
     * terrain.
     */
    @Defaults("file")
    public static ModelSettings of(String file) {
        ModelRole role = file.equals(HILL) ? ModelRole.TERRAIN : ModelRole.BUILDING;
        return new ModelSettings(file, UpAxis.Y, 1.0, FilePoint.ZERO, new Position(0, 0, 0), 0.0, role);
    }

    /** A model of the library, such as {@code hill.obj}. */
    public static ModelSettings packaged(String name) {
        return of(PACKAGED + name);
    }

    /** These settings with another axis up. */
    public ModelSettings withUpAxis(UpAxis axis) {
        return SettingsForm.with(this, "upAxis", axis);
    }

    /** These settings with another scale, metres for each unit of the file. */
    public ModelSettings withScale(double factor) {
        return SettingsForm.with(this, "scale", factor);
    }

    /** These settings with another point of the file placed at the position, in the file's unit and along its axes. */
    public ModelSettings withOrigin(FilePoint point) {
        return SettingsForm.with(this, "origin", point);
    }

    /** These settings with another position, m. */
    public ModelSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    /** These settings with another heading, rad clockwise from above. */
    public ModelSettings withHeading(double angle) {
        return SettingsForm.with(this, "heading", angle);
    }

    /** These settings with another role on the site. */
    public ModelSettings withRole(ModelRole other) {
        return SettingsForm.with(this, "role", other);
    }

    /** The file's name in results: without {@value #PACKAGED}. */
    public String shownFile() {
        return file.startsWith(PACKAGED) ? file.substring(PACKAGED.length()) : file;
    }
}
