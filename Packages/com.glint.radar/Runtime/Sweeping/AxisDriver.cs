using Glint.Core;

namespace Glint
{
    /// <summary>Applies the values of a sweep axis to the scene.</summary>
    public abstract class AxisDriver
    {
        private protected AxisDriver()
        {
        }

        /// <summary>Applies a pose's value on the axis.</summary>
        /// <exception cref="GlintException">The object to move was destroyed.</exception>
        internal abstract void Show(SweepPose pose);

        /// <summary>Restores the state before the first pose.</summary>
        internal abstract void PutBack();
    }
}
