package org.dronewatch.mesh.io;

import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
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
 * to stand upright, scaled, rotated to its heading, and moved to its position, all in double precision. With a
 * {@code crs}, the coordinates after scaling are those of a national grid: they are transformed to the scene's frame by
 * way of latitude and longitude, which accounts for the angle between grid north and true north, the scale of the grid,
 * and the curvature of the earth; {@code position} then moves the model from there.
 *
 * @param file path of a model file, such as an .obj file, or {@code packaged:NAME} for a model of the library
 * @param upAxis axis of the file that points up
 * @param scale length of the file's unit, 1e-6 to 1e6 m
 * @param crs national grid of the file's coordinates by its EPSG code, such as EPSG:28992, with heights measured from
 *     the same level as {@code world.origin.height}; omit it for a model in local coordinates
 * @param origin point of the file that is placed at {@code position}, in the file's unit and along its axes; with a
 *     {@code crs}, the point at which the coordinates of the grid are zero, which matters only if the file's
 *     coordinates are shifted: (-155000, -463000, 0) if 155,000 and 463,000 were subtracted from them
 * @param position position of the model's origin, m; with a {@code crs}, a correction of the model's position
 * @param heading rotation about the vertical, clockwise as seen from above, rad; 0 with a {@code crs}, which determines
 *     the direction of north
 * @param role role of the model on the site, by which reports classify the obstacles that hide drones; heights in the
 *     wind profile are measured from models whose role is terrain, if there are any; it has no effect on a drone's
 *     model
 */
public record ModelSettings(
        @FileName(unless = ModelSettings.PACKAGED) String file,
        UpAxis upAxis,
        @In(value = Quantity.NUMBER, from = 1e-6, to = 1e6) double scale,
        @Minor Optional<String> crs,
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
     * @throws IllegalArgumentException if a value is out of range, the code of the coordinate reference system is not
     *     that of a grid, or both a coordinate reference system and a heading other than 0 are given
     */
    public ModelSettings {
        Limits.check(ModelSettings.class, file, upAxis, scale, crs, origin, position, heading, role);
        if (file.isBlank()) {
            throw new IllegalArgumentException("file is empty: it must name a model file");
        }
        CoordinateReferenceSystem.checkSetting(crs);
        if (crs.map(CoordinateReferenceSystem::of)
                .filter(CoordinateReferenceSystem::isGeographic)
                .isPresent()) {
            throw new IllegalArgumentException(
                    "crs " + crs.get() + " has coordinates in degrees: a model needs a grid in metres or feet");
        }
        if (crs.isPresent() && heading != 0.0) {
            throw new IllegalArgumentException("heading must be 0 deg if 'crs' is given, not "
                    + Quantity.ANGLE.inWords(heading) + ": the grid defines the direction of north");
        }
    }

    /**
     * A file with y up and in metres, like most OBJ files, placed at the origin; a building unless it is the packaged
     * hill, which is terrain.
     */
    @Defaults("file")
    public static ModelSettings of(String file) {
        ModelRole role = file.equals(HILL) ? ModelRole.TERRAIN : ModelRole.BUILDING;
        return new ModelSettings(
                file, UpAxis.Y, 1.0, Optional.empty(), FilePoint.ZERO, new Position(0, 0, 0), 0.0, role);
    }

    /** A model of the library, such as {@code hill.obj}. */
    public static ModelSettings packaged(String name) {
        return of(PACKAGED + name);
    }

    /** These settings with another up axis. */
    public ModelSettings withUpAxis(UpAxis axis) {
        return SettingsForm.with(this, "upAxis", axis);
    }

    /** These settings with another scale, metres for each unit of the file. */
    public ModelSettings withScale(double factor) {
        return SettingsForm.with(this, "scale", factor);
    }

    /** These settings with coordinates of a national grid, such as {@code EPSG:28992}. */
    public ModelSettings withCrs(String code) {
        return SettingsForm.with(this, "crs", Optional.of(code));
    }

    /** These settings with another point of the file placed at the position, in the file's unit and along its axes. */
    public ModelSettings withOrigin(FilePoint point) {
        return SettingsForm.with(this, "origin", point);
    }

    /** These settings with another position, m. */
    public ModelSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    /** These settings with another heading, clockwise as seen from above, rad. */
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
