using Glint.Core;

namespace Glint
{
    /// <summary>How a sweep moves what one of its axes stands for.</summary>
    public abstract class AxisDriver
    {
        private protected AxisDriver()
        {
        }

        /// <summary>Shows a pose's value on the axis.</summary>
        /// <exception cref="GlintException">What was to be moved is gone.</exception>
        internal abstract void Show(SweepPose pose);

        /// <summary>Leaves everything as it was before the first pose.</summary>
        internal abstract void PutBack();
    }
}
