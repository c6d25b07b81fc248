namespace Glint.Vulkan;

/// <summary>One Vulkan device of this machine.</summary>
/// <param name="Index">Index in <see cref="VulkanDevice.List"/>, which selects it.</param>
/// <param name="Type">"discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other".</param>
/// <param name="ApiVersion">Vulkan version of the device, for example "1.3.230".</param>
/// <param name="Driver">Name and version of its driver.</param>
public sealed record DeviceInfo(int Index, string Name, string Type, string ApiVersion, string Driver,
    uint VendorId, uint DeviceId);
