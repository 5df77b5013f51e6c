/**
 * The common parts of all kinds of sensors: settings and their capabilities, looks, observations, assessments and
 * detections.
 */
package org.dronewatch.sensor;
