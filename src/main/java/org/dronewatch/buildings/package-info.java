/** The buildings of a real place: outlines and heights of a map are converted to solids in the world frame. */
package org.dronewatch.buildings;
