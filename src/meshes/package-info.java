/** Files of meshes: Wavefront OBJ text files, also zipped. */
package meshes;
