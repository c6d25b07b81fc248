using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>How much memory BVHs may take, from what Unity reports of the device and the computer.</summary>
    public sealed class DeviceMemoryLimitTests
    {
        [TestCase(128, 16384, 8192, TestName = "Limit_IntegratedGpu_IsHalfOfTheComputersMemory")]
        [TestCase(512, 4096, 2048, TestName = "Limit_IntegratedGpuOfASmallComputer_IsHalfOfItsMemory")]
        [TestCase(2048, 3072, 2048, TestName = "Limit_IntegratedGpuWithMoreReserved_IsWhatIsReserved")]
        [TestCase(8192, 65536, 8192, TestName = "Limit_GpuWithMemoryOfItsOwn_IsThatMemory")]
        public void Limit(int graphics, int system, int usable) =>
            Assert.That(DeviceBvhs.UsableMebibytes(graphics, system), Is.EqualTo(usable));
    }
}
