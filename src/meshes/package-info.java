/** Files of meshes, which are Wavefront OBJ text files, also zipped; of their materials; and of textures. */
package meshes;
