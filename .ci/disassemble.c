// disassemble FILE ENTRY LEVEL: compiles a preprocessed HLSL file for cs_5_0 with D3DCompile at optimisation level 0 to 3, and prints the
// listing of the byte code. Exit status: 0 printed, 1 rejected (with the compiler's messages), 2 could not run.
#include <windows.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Blob Blob;
struct Blob { struct { void *base[3]; LPVOID (WINAPI *Pointer)(Blob *); SIZE_T (WINAPI *Size)(Blob *); } *v; };
typedef HRESULT (WINAPI *Compile)(LPCVOID, SIZE_T, LPCSTR, const void *, void *, LPCSTR, LPCSTR, UINT, UINT, Blob **, Blob **);
typedef HRESULT (WINAPI *Disassemble)(LPCVOID, SIZE_T, UINT, LPCSTR, Blob **);

int main(int argc, char **argv) {
    // D3DCOMPILE_OPTIMIZATION_LEVEL0 to 3
    static const UINT levels[] = { 1 << 14, 0, 3 << 14, 1 << 15 };
    HMODULE dll = LoadLibraryA("d3dcompiler_47.dll");
    Compile compile = dll ? (Compile)GetProcAddress(dll, "D3DCompile") : NULL;
    Disassemble disassemble = dll ? (Disassemble)GetProcAddress(dll, "D3DDisassemble") : NULL;
    FILE *file = argc == 4 ? fopen(argv[1], "rb") : NULL;
    if (!compile || !disassemble || !file) { fprintf(stderr, "usage: disassemble FILE ENTRY LEVEL, with d3dcompiler_47.dll\n"); return 2; }
    char *source = malloc(1 << 22);
    SIZE_T size = fread(source, 1, 1 << 22, file);
    Blob *code = NULL, *messages = NULL, *listing = NULL;
    if (FAILED(compile(source, size, argv[1], NULL, NULL, argv[2], "cs_5_0", levels[atoi(argv[3]) & 3], 0, &code, &messages))) {
        fprintf(stderr, "%s\n", messages ? (char *)messages->v->Pointer(messages) : "rejected without a message");
        return 1;
    }
    if (FAILED(disassemble(code->v->Pointer(code), code->v->Size(code), 0, NULL, &listing))) return 2;
    printf("%s", (char *)listing->v->Pointer(listing));
    return 0;
}
