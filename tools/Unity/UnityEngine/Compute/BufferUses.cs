namespace Glint.Host;

/// <summary>How a kernel may use a buffer.</summary>
/// <param name="Structured">As a StructuredBuffer.</param>
/// <param name="Raw">As a ByteAddressBuffer.</param>
/// <param name="Arguments">As the group counts of DispatchIndirect.</param>
internal readonly record struct BufferUses(bool Structured, bool Raw, bool Arguments);
