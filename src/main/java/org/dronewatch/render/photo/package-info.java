/**
 * What a camera would photograph: materials, sun, sky and haze in colour. Nothing here decides what a sensor detects.
 */
package org.dronewatch.render.photo;
